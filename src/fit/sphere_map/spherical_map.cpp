#include "fit/sphere_map/spherical_map.h"

#include <cmath>

#include <fmt/core.h>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/unit_box.h"
#include "fit/sphere_map/curvature_flow.h"
#include "fit/sphere_map/progressive_map.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

void check_sphere(const SurfaceMesh& mesh, const HalfEdgeMesh& half_edges) {
    const auto euler = std::ptrdiff_t(mesh.positions.size()) - std::ptrdiff_t(mesh.triangles.size() / 2);
    if (euler != 2) throw InputError(fmt::format("the surface has Euler number {}, 2 is expected", euler));
    if (mesh.positions.size() < 4) throw InputError("the surface has fewer than 4 vertices");
    if (!half_edges.is_connected()) throw InputError("the surface is not in one piece");
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 p = mesh.positions[i];
        if (!(std::abs(p.x) < 1e300 && std::abs(p.y) < 1e300 && std::abs(p.z) < 1e300))
            throw InputError(fmt::format("vertex {} is at ({}, {}, {})", i, p.x, p.y, p.z));
    }
}

}  // namespace

SphericalMap map_to_sphere(const SurfaceMesh& mesh, const Progress& progress, Keeps keeps, double crowded) {
    ProgressMeter meter(progress);
    meter.enter("mapping to the sphere", 0);
    HalfEdgeMesh half_edges(static_cast<Index>(mesh.positions.size()), mesh.triangles);
    check_sphere(mesh, half_edges);
    const std::vector<glm::dvec3> positions = in_unit_box(mesh.positions);

    std::string faults;
    const auto is_good = [&](std::string_view method, std::span<const glm::dvec3> points, std::string fault) {
        if (fault.empty()) fault = fault_of_map(mesh, points);
        if (!fault.empty()) faults += fmt::format("{}{}: {}", faults.empty() ? "" : "; ", method, fault);
        return fault.empty();
    };
    ProgressiveMap map =
        map_progressively(half_edges, positions, {.keeps = keeps, .crowded = crowded}, meter);
    if (is_good("progressive", map.points, map.failure))
        return {std::move(map.points), MapMethod::progressive};
    ProgressiveOptions careful = careful_options;
    careful.keeps = keeps;
    careful.crowded = crowded;
    map = map_progressively(half_edges, positions, careful, meter);
    if (is_good("careful progressive", map.points, map.failure))
        return {std::move(map.points), MapMethod::careful_progressive};
    std::vector<glm::dvec3> points = map_by_curvature_flow(half_edges, positions, {}, meter);
    if (is_good("curvature flow", points, {})) return {std::move(points), MapMethod::curvature_flow};
    throw InputError(fmt::format("the surface could not be mapped to a sphere one to one ({})", faults));
}

}  // namespace interleaf
