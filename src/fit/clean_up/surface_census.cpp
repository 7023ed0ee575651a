#include "fit/clean_up/surface_census.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "fit/clean_up/edge_pairing.h"
#include "fit/clean_up/near_welding.h"
#include "fit/clean_up/surface_splitting.h"
#include "fit/clean_up/triangle_soup.h"
#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/unit_box.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

std::size_t count_used(const SurfaceMesh& mesh) {
    std::vector<char> is_used(mesh.positions.size(), 0);
    for (const Triangle& triangle : mesh.triangles)
        for (const Index vertex : triangle) is_used[vertex] = 1;
    return static_cast<std::size_t>(std::ranges::count(is_used, 1));
}

double area_of(const SurfaceMesh& mesh) {
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area += glm::length(glm::cross(mesh.positions[b] - mesh.positions[a],
                                       mesh.positions[c] - mesh.positions[a])) /
                2;
    return area;
}

/// The volume that each component encloses, positive if the component looks outward.
std::vector<double> volumes_of(const SurfaceMesh& mesh, std::span<const Index> component, std::size_t count) {
    std::vector<double> volumes(count, 0);
    const glm::dvec3 origin = mesh.positions[mesh.triangles.front()[0]];
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.triangles[i];
        volumes[component[i]] +=
            glm::dot(mesh.positions[a] - origin,
                     glm::cross(mesh.positions[b] - origin, mesh.positions[c] - origin)) /
            6;
    }
    return volumes;
}

/// Number of rims, that is, closed paths of half-edges without a partner.
std::size_t count_openings(std::span<const Index> twin) {
    std::vector<char> is_done(twin.size(), 0);
    std::size_t openings = 0;
    for (Index start = 0; start < twin.size(); ++start) {
        if (twin[start] != no_index || is_done[start]) continue;
        ++openings;
        for (Index edge = start; !is_done[edge];) {
            is_done[edge] = 1;
            edge = HalfEdgeMesh::next(edge);
            while (twin[edge] != no_index) edge = HalfEdgeMesh::next(twin[edge]);
        }
    }
    return openings;
}

}  // namespace

SurfaceCensus census_as_it_is(SurfaceMesh mesh) {
    SurfaceCensus census;
    census.vertices = count_used(mesh);
    census.triangles = mesh.triangles.size();
    if (mesh.triangles.empty()) return census;
    census.area = area_of(mesh);

    const Progress none;
    ProgressMeter meter(none);
    auto [twin, crowded_edges] = pair_edges(in_unit_box(mesh.positions), mesh.triangles, meter);
    census.crowded_edges = crowded_edges;
    const std::vector<Index> component = components_of(twin, meter);
    census.parts = 1 + *std::ranges::max_element(component);
    const auto open = std::ranges::count(twin, no_index);
    bool agreed = false;
    try {
        agreed = make_agree(mesh.triangles, twin, meter) == 0;
    } catch (const InputError&) {  // one-sided
        return census;
    }
    census.openings = count_openings(twin);
    if (open == 0) {
        double signed_sum = 0;
        double sum = 0;
        for (const double volume : volumes_of(mesh, component, census.parts)) {
            signed_sum += volume;
            sum += std::abs(volume);
        }
        census.volume = agreed ? std::abs(signed_sum) : sum;
    }
    const auto edges = (3 * std::ptrdiff_t(mesh.triangles.size()) + open) / 2;
    const auto vertices = std::ptrdiff_t(split_vertices(mesh, twin, meter).size());
    const std::ptrdiff_t euler = vertices - edges + std::ptrdiff_t(mesh.triangles.size());
    census.handles =
        std::size_t((2 * std::ptrdiff_t(census.parts) - euler - std::ptrdiff_t(census.openings)) / 2);
    return census;
}

SurfaceCensus census_of(SurfaceMesh mesh) {
    const Progress none;
    ProgressMeter meter(none);
    const std::size_t vertices = count_used(mesh);
    const std::size_t triangles = mesh.triangles.size();
    const std::vector<Index> first = first_at_same_point(mesh.positions, meter);
    for (Triangle& triangle : mesh.triangles)
        for (Index& vertex : triangle) vertex = first[vertex];
    remove_degenerate(mesh.triangles);
    weld_nearby(mesh.positions, mesh.triangles, meter);
    remove_duplicates(mesh.triangles, meter);
    SurfaceCensus census = census_as_it_is(std::move(mesh));
    census.welded_vertices = vertices - census.vertices;
    census.removed_triangles = triangles - census.triangles;
    return census;
}

}  // namespace interleaf
