#include "fit/sphere_map/alignment.h"

#include <vector>

#include <glm/geometric.hpp>

#include "hierarchy/rotation_fit.h"

namespace interleaf {
namespace {

/// Directions of the vertices from the surface's center of area. The length of each direction is the
/// vertex's fraction of the area.
std::vector<glm::dvec3> weighted_directions(const SurfaceMesh& mesh) {
    std::vector<double> areas(mesh.positions.size(), 0.0);
    double whole = 0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const glm::dvec3& a = mesh.positions[i];
        const double area = glm::length(glm::cross(mesh.positions[j] - a, mesh.positions[k] - a));
        whole += area;
        for (const Index vertex : {i, j, k}) areas[vertex] += area / 3;
    }
    if (!(whole > 0)) return std::vector<glm::dvec3>(mesh.positions.size(), glm::dvec3(0));
    glm::dvec3 center(0);
    for (std::size_t v = 0; v < areas.size(); ++v) center += areas[v] / whole * mesh.positions[v];

    std::vector<glm::dvec3> directions(mesh.positions.size());
    for (std::size_t v = 0; v < areas.size(); ++v) {
        const glm::dvec3 from_center = mesh.positions[v] - center;
        const double length = glm::length(from_center);
        directions[v] = length > 0 ? areas[v] / whole / length * from_center : glm::dvec3(0);
    }
    return directions;
}

}  // namespace

glm::dmat3 rotation_to_surface(const SurfaceMesh& mesh, std::span<const glm::dvec3> points) {
    return fit_rotation(points, weighted_directions(mesh)).rotation;
}

double mean_cosine(const SurfaceMesh& mesh, std::span<const glm::dvec3> points) {
    const std::vector<glm::dvec3> directions = weighted_directions(mesh);
    double mean = 0;
    for (std::size_t v = 0; v < points.size(); ++v) mean += glm::dot(points[v], directions[v]);
    return mean;
}

void rotate(std::span<glm::dvec3> points, const glm::dmat3& rotation) {
    for (glm::dvec3& point : points) point = glm::normalize(rotation * point);
}

}  // namespace interleaf
