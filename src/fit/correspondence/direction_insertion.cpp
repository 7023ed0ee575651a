#include "fit/correspondence/direction_insertion.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "fit/sampling/sphere_location.h"

namespace interleaf {
namespace {

/// The point of \p mesh in \p direction. Looks at all triangles, because the mesh changes from one direction to the
/// next.
MeshPoint point_of_mesh(const SphereMesh& mesh, const glm::dvec3& direction) {
    MeshPoint best;
    double largest = -std::numeric_limits<double>::infinity();
    for (Index t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [i, j, k] = mesh.triangles[t];
        const glm::dvec3& a = mesh.points[i];
        const glm::dvec3& b = mesh.points[j];
        const glm::dvec3& c = mesh.points[k];
        if (!(glm::dot(direction, a + b + c) > 0)) continue;
        const glm::dvec3 volumes(side_of_arc(b, c, direction), side_of_arc(c, a, direction),
                                 side_of_arc(a, b, direction));
        const double sum = volumes.x + volumes.y + volumes.z;
        if (!(sum > 0)) continue;
        const glm::dvec3 place = volumes / sum;
        const double least = std::min({place.x, place.y, place.z});
        if (least <= largest) continue;
        largest = least;
        best = {t, place};
    }
    return best;
}

Index insert_point(SphereMesh& mesh, MeshPoint point) {
    constexpr double at_border = 1e-3;
    const Triangle corners = mesh.triangles[point.triangle];
    glm::dvec3& place = point.barycentric;
    for (glm::length_t k = 0; k < 3; ++k)
        if (place[k] > 1 - 2 * at_border) return corners[static_cast<std::size_t>(k)];
    place = glm::max(place, glm::dvec3(at_border));
    place /= place.x + place.y + place.z;
    const auto middle = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(
        point.of(std::span<const Triangle>(mesh.triangles), std::span<const glm::dvec3>(mesh.positions)));
    mesh.points.push_back(glm::normalize(
        point.of(std::span<const Triangle>(mesh.triangles), std::span<const glm::dvec3>(mesh.points))));
    mesh.triangles[point.triangle] = {corners[0], corners[1], middle};
    mesh.triangles.push_back({corners[1], corners[2], middle});
    mesh.triangles.push_back({corners[2], corners[0], middle});
    return middle;
}

}  // namespace

void insert_directions(SphereMesh& mesh, std::span<const glm::dvec3> directions) {
    for (const glm::dvec3& direction : directions) {
        const MeshPoint point = point_of_mesh(mesh, direction);
        if (point.triangle == no_index) continue;
        const Index vertex = insert_point(mesh, point);
        if (std::ranges::find(mesh.landmarks, vertex, &SphereLandmark::vertex) == mesh.landmarks.end())
            mesh.landmarks.push_back({vertex, direction});
    }
}

}  // namespace interleaf
