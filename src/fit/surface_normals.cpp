#include "fit/surface_normals.h"

#include <glm/geometric.hpp>

namespace interleaf {

glm::dvec3 unit_normal(const TriangleCorners& corners) {
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : glm::dvec3(0);
}

std::vector<glm::dvec3> unit_normals(std::span<const Triangle> triangles,
                                     std::span<const glm::dvec3> positions) {
    std::vector<glm::dvec3> normals;
    normals.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles)
        normals.push_back(unit_normal({positions[a], positions[b], positions[c]}));
    return normals;
}

bool is_turned_over(const Triangle& leaf, const SampledSurface& surface, const SphereLocation& location,
                    std::span<const glm::dvec3> normals) {
    const auto& [a, b, c] = leaf;
    const glm::dvec3 &u = surface.sphere_points[a], &v = surface.sphere_points[b],
                     &w = surface.sphere_points[c];
    glm::dvec3 normal(0);
    Index guess = surface.mesh_points[a].triangle;
    for (const glm::dvec3& inside : {u + v + w, 4.0 * u + v + w, u + 4.0 * v + w, u + v + 4.0 * w}) {
        guess = location.locate(glm::normalize(inside), guess).triangle;
        normal += normals[guess];
    }
    const glm::dvec3 first(surface.positions[a]);
    const glm::dvec3 of_leaf =
        glm::cross(glm::dvec3(surface.positions[b]) - first, glm::dvec3(surface.positions[c]) - first);
    return !(glm::dot(normal, of_leaf) > 0);
}

}  // namespace interleaf
