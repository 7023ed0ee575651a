#include "fit/sphere_map/progressive_map.h"

#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/sphere_map/progressive_mapping.h"

namespace interleaf {

ProgressiveMap map_progressively(HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
                                 const ProgressiveOptions& options, ProgressMeter& meter) {
    ProgressiveMapping mapping(mesh, positions, options, meter);
    mapping.collapse();
    if (mapping.raise(mesh.vertex_capacity())) return {std::move(mapping.points()), {}};
    std::string failure = mapping.failure();
    mapping.restore_mesh();
    return {{}, std::move(failure)};
}

std::vector<double> solid_angles_wanted(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions) {
    std::vector<double> areas(positions.size(), 0);
    double whole = 0;
    for (Index triangle = 0; triangle < mesh.triangle_capacity(); ++triangle) {
        const Index a = mesh.origin(3 * triangle);
        const Index b = mesh.origin(3 * triangle + 1);
        const Index c = mesh.origin(3 * triangle + 2);
        const double area =
            glm::length(glm::cross(positions[b] - positions[a], positions[c] - positions[a])) / 2;
        for (const Index vertex : {a, b, c}) areas[vertex] += area / 3;
        whole += area;
    }
    constexpr double least = 1e-4;  // of the mean, for vertices whose triangles have no area
    const double floor = whole > 0 ? least * whole / double(areas.size()) : 1;
    const double scale = 4 * std::numbers::pi / (whole + floor * double(areas.size()));
    for (double& area : areas) area = (area + floor) * scale;
    return areas;
}

}  // namespace interleaf
