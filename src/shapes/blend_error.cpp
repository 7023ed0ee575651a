#include "shapes/blend_error.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

namespace interleaf {
namespace {

/// The points of the base that the vertices of \p mesh stand for.
std::vector<glm::dvec3> base_points_of(const BaseSurface& base, const UnionMesh& mesh) {
    const Hierarchy roots = base.roots();
    std::vector<glm::dvec3> points;
    points.reserve(mesh.vertex_count());
    for (const VertexOrigin& vertex : mesh.vertices) {
        const auto [a, b] = vertex.edge;
        const glm::dvec3 flat =
            a == no_index ? glm::dvec3(roots.positions[points.size()]) : (points[a] + points[b]) / 2.0;
        points.push_back(base.project(flat));
    }
    return points;
}

}  // namespace

double distance_from(const Shape& shape, const UnionMesh& mesh, std::span<const glm::vec3> positions) {
    const std::vector<glm::dvec3> base_points = base_points_of(shape.base, mesh);
    double distance = 0;
    for (std::size_t v = 0; v < base_points.size(); ++v)
        distance = std::max(distance, glm::distance(shape.surface(base_points[v]), glm::dvec3(positions[v])));
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 center =
            (glm::dvec3(positions[a]) + glm::dvec3(positions[b]) + glm::dvec3(positions[c])) / 3.0;
        const glm::dvec3 base = shape.base.project((base_points[a] + base_points[b] + base_points[c]) / 3.0);
        distance = std::max(distance, glm::distance(shape.surface(base), center));
    }
    return distance;
}

}  // namespace interleaf
