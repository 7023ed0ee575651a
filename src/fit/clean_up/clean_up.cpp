#include "fit/clean_up/clean_up.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "fit/clean_up/edge_pairing.h"
#include "fit/clean_up/hole_filling.h"
#include "fit/clean_up/near_welding.h"
#include "fit/clean_up/surface_splitting.h"
#include "fit/clean_up/triangle_soup.h"
#include "fit/mesh/unit_box.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

void check_numbers(const SurfaceMesh& mesh) {
    constexpr std::size_t most = std::size_t{1} << 30;  // half-edges and their sums are counted in 32 bits
    if (mesh.triangles.empty()) throw InputError("the mesh has no triangles");
    if (mesh.triangles.size() > most || mesh.positions.size() > most)
        throw InputError(
            fmt::format("the mesh has {} vertices and {} triangles, at most 2^30 of each are expected",
                        mesh.positions.size(), mesh.triangles.size()));
    if (!mesh.colors.empty() && mesh.colors.size() != mesh.positions.size())
        throw InputError(
            fmt::format("the mesh has {} colors for {} vertices", mesh.colors.size(), mesh.positions.size()));
    for (const MeshField& scalar : mesh.scalars)
        if (scalar.values.size() != mesh.positions.size())
            throw InputError(fmt::format("field {} has {} values for {} vertices", scalar.name,
                                         scalar.values.size(), mesh.positions.size()));
    const auto is_good = [](double number) {  // false for a NaN, too
        return std::abs(number) <= std::numeric_limits<float>::max();
    };
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 p = mesh.positions[i];
        if (!is_good(p.x) || !is_good(p.y) || !is_good(p.z))
            throw InputError(fmt::format(
                "vertex {} is at ({}, {}, {}); numbers that fit a float are expected", i, p.x, p.y, p.z));
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const Index vertex : mesh.triangles[i])
            if (vertex >= mesh.positions.size())
                throw InputError(fmt::format("triangle {} names vertex {}, but there are {}", i, vertex,
                                             mesh.positions.size()));
}

std::vector<double> areas_of(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions) {
    std::vector<double> areas;
    areas.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles)
        areas.push_back(glm::length(glm::cross(positions[b] - positions[a], positions[c] - positions[a])) /
                        2);
    return areas;
}

/// Keeps the component with the largest area; the first one if several are equal.
/// \return the triangles of the other components, with the vertex indices of \p mesh
std::vector<Triangle> keep_largest(std::vector<Triangle>& triangles, std::vector<Index>& twin,
                                   std::span<const glm::dvec3> positions, CleanUpReport& report,
                                   ProgressMeter& meter) {
    const std::vector<Index> component = components_of(twin, meter);
    const std::vector<double> areas = areas_of(triangles, positions);
    std::vector<DroppedPart> parts(1 + *std::max_element(component.begin(), component.end()));
    double whole = 0;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        ++parts[component[i]].triangles;
        parts[component[i]].area += areas[i];
        whole += areas[i];
    }
    const auto largest = std::ranges::max_element(parts, {}, &DroppedPart::area);
    const auto kept = static_cast<Index>(largest - parts.begin());

    std::vector<Triangle> dropped;
    std::vector<Index> number(triangles.size(), no_index);
    Index count = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (component[i] == kept)
            number[i] = count++;
        else
            dropped.push_back(triangles[i]);
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (number[i] == no_index) continue;
        triangles[number[i]] = triangles[i];
        for (Index k = 0; k < 3; ++k) {
            const Index partner = twin[3 * i + k];
            twin[3 * number[i] + k] = partner == no_index ? no_index : 3 * number[partner / 3] + partner % 3;
        }
    }
    triangles.resize(count);
    twin.resize(3 * std::size_t(count));

    parts.erase(largest);
    for (DroppedPart& part : parts) {
        if (whole > 0) part.area /= whole;
        report.dropped_area += part.area;
    }
    std::ranges::stable_sort(parts, std::greater(), &DroppedPart::area);
    report.dropped_parts = std::move(parts);
    return dropped;
}

/// \p triangles, with only the vertices that they use.
SurfaceMesh used_part(std::span<const glm::dvec3> positions, std::vector<Triangle> triangles) {
    SurfaceMesh part;
    std::vector<Index> number(triangles.empty() ? 0 : positions.size(), no_index);
    for (Triangle& triangle : triangles)
        for (Index& vertex : triangle) {
            if (number[vertex] == no_index) {
                number[vertex] = static_cast<Index>(part.positions.size());
                part.positions.push_back(positions[vertex]);
            }
            vertex = number[vertex];
        }
    part.triangles = std::move(triangles);
    return part;
}

/// Fills the holes. Refuses holes that are as large as the surface.
void fill(SurfaceMesh& mesh, std::span<const Index> twin, CleanUpReport& report, ProgressMeter& meter) {
    constexpr double max_part = 0.95;  // of the surface's own area; allows the lid of a shallow dish
    const std::size_t own_count = mesh.triangles.size();
    const std::vector<FilledHole> holes = fill_holes(mesh, twin, meter);
    if (holes.empty()) return;
    const std::vector<double> areas = areas_of(mesh.triangles, in_unit_box(mesh.positions));
    const auto sum = [&](std::size_t begin, std::size_t end) {
        return std::accumulate(areas.begin() + std::ptrdiff_t(begin), areas.begin() + std::ptrdiff_t(end),
                               0.0);
    };
    const double own = sum(0, own_count);
    std::size_t begin = own_count;
    for (const FilledHole& hole : holes) {
        report.fillings.push_back({hole.edges, hole.triangles, sum(begin, begin + hole.triangles) / own});
        report.made_area += report.fillings.back().area;
        begin += hole.triangles;
    }
    std::ranges::stable_sort(report.fillings, std::greater(), &MadeFilling::area);
    if (!(report.made_area < max_part))
        throw InputError(fmt::format(
            "the surface is an open sheet, not closed: to fill its {} would take {:.0f} % of its own area{}",
            holes.size() == 1 ? "hole" : fmt::format("{} holes", holes.size()), 100 * report.made_area,
            report.dropped_parts.empty()
                ? ""
                : fmt::format("; it is the largest of {} parts", report.dropped_parts.size() + 1)));
}

void check_genus(const SurfaceMesh& mesh) {
    const auto faces = std::ptrdiff_t(mesh.triangles.size());
    const std::ptrdiff_t euler = std::ptrdiff_t(mesh.positions.size()) - faces / 2;
    if (euler != 2)
        throw InputError(fmt::format(
            "the surface has {}, its Euler number is {}; a surface like a ball (genus 0, Euler number 2) is "
            "expected",
            euler == 0 ? "a handle, like a torus" : fmt::format("{} handles", (2 - euler) / 2), euler));
    if (mesh.positions.size() < 4)
        throw InputError("the surface is a single triangle; a closed surface is expected");
}

/// Turns the surface so that it encloses a positive volume.
/// \return whether it had to be turned
bool turn_outward(SurfaceMesh& mesh) {
    const std::vector<glm::dvec3> positions = in_unit_box(mesh.positions);
    double volume = 0;
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 origin = positions.front();
        const glm::dvec3 normal = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
        volume += glm::dot(positions[a] - origin, normal) / 6;
        area += glm::length(normal) / 2;
    }
    constexpr double least = 1e-7;  // a ball of the same area has about 0.1
    if (!(std::abs(volume) > least * area * std::sqrt(area)))
        throw InputError("the surface encloses no volume: it is flat or folded onto itself");
    if (volume > 0) return false;
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return true;
}

/// Replaces each vertex in the triangles by the first equal one.
void weld_equal(SurfaceMesh& mesh, CleanUpReport& report, ProgressMeter& meter) {
    const std::vector<Index> first = first_at_same_point(mesh.positions, meter);
    std::vector<char> is_welded(first.size(), 0);
    for (Triangle& triangle : mesh.triangles)
        for (Index& vertex : triangle) {
            is_welded[vertex] = first[vertex] != vertex;
            vertex = first[vertex];
        }
    report.welded_vertices = static_cast<std::size_t>(std::ranges::count(is_welded, 1));
}

/// Refuses meshes that are not surfaces: triangles that share no edges, and the faces inside a volume mesh.
void check_edges(std::size_t triangles, std::span<const Index> twin, std::size_t crowded_edges) {
    const auto open = static_cast<std::size_t>(std::ranges::count(twin, no_index));
    constexpr std::size_t min_triangles = 8;
    if (triangles >= min_triangles && open == twin.size() && crowded_edges == 0)
        throw InputError(fmt::format(
            "no two of the {} triangles share an edge: their corners are apart, and too far to be joined",
            triangles));
    constexpr std::size_t min_of_volume = 100;
    if (triangles >= min_of_volume && 4 * crowded_edges > triangles)
        throw InputError(
            fmt::format("more than two triangles meet at {} edges of {} triangles: these may be all faces of "
                        "a volume mesh; its "
                        "outer surface is expected",
                        crowded_edges, triangles));
}

}  // namespace

CleanMesh clean_up(SurfaceMesh mesh, const Progress& progress) {
    ProgressMeter meter(progress);
    meter.enter("cleaning up", 0);
    check_numbers(mesh);
    CleanUpReport report;

    weld_equal(mesh, report, meter);
    report.degenerate_triangles = remove_degenerate(mesh.triangles);
    if (mesh.triangles.empty()) throw InputError("each triangle of the mesh names some point twice");
    meter.set_part(0.2);
    report.nearly_equal_vertices = weld_nearby(mesh.positions, mesh.triangles, meter);
    report.duplicate_triangles = remove_duplicates(mesh.triangles, meter);

    meter.set_part(0.4);
    const std::vector<glm::dvec3> positions = in_unit_box(mesh.positions);
    auto [twin, crowded_edges] = pair_edges(positions, mesh.triangles, meter);
    report.crowded_edges = crowded_edges;
    check_edges(mesh.triangles.size(), twin, crowded_edges);
    meter.set_part(0.6);
    const SurfaceMesh dropped =
        used_part(mesh.positions, keep_largest(mesh.triangles, twin, positions, report, meter));
    report.turned_triangles = make_agree(mesh.triangles, twin, meter);

    meter.set_part(0.7);
    std::vector<Index> source = split_vertices(mesh, twin, meter);
    std::vector<Index> distinct = source;
    report.split_vertices =
        source.size() - std::size_t(std::unique(distinct.begin(), distinct.end()) - distinct.begin());
    report.split_edges = split_double_edges(mesh, twin, meter);
    meter.set_part(0.9);
    fill(mesh, twin, report, meter);
    source.resize(mesh.positions.size(), no_index);

    check_genus(mesh);
    report.turned_outward = turn_outward(mesh);
    meter.enter("cleaning up", 1);
    return {std::move(mesh), std::move(report), std::move(source), dropped};
}

}  // namespace interleaf
