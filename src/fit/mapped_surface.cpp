#include "fit/mapped_surface.h"

#include <glm/geometric.hpp>

namespace interleaf {

glm::dvec3 unit_normal(const TriangleCorners& corners) {
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : glm::dvec3(0);
}

MappedSurface::MappedSurface(const SurfaceMesh& surface, std::span<const glm::dvec3> map)
    : mesh(surface), points(map), location(mesh.triangles, points), distance(mesh.triangles, mesh.positions) {
    normals.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
        normals.push_back(unit_normal({mesh.positions[a], mesh.positions[b], mesh.positions[c]}));
}

}  // namespace interleaf
