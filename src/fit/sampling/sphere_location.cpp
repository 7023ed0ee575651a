#include "fit/sampling/sphere_location.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "fit/mesh/half_edge_mesh.h"

namespace interleaf {
namespace {

/// Maximum length of a walk. A walk from nearby ends sooner, and a walk might go in circles.
constexpr int max_steps = 24;

/// Boxes are enlarged by this, so that rounding leaves no direction outside all boxes.
constexpr double rounding = 1e-12;

/// A box of the spherical triangle with these corners.
///
/// The spherical triangle bulges out of the flat triangle by at most 1 - |q|, where q is the point of the
/// flat triangle nearest to the origin. q is a weighted mean of the corners, so |q|^2 is 1 minus their mean
/// squared distance from q. That distance is at most the squared radius of a ball around the triangle: a
/// third of the square of its longest edge (Jung 1901).
SpaceBox box_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const auto squared_distance = [](const glm::dvec3& p, const glm::dvec3& q) {
        return glm::dot(p - q, p - q);
    };
    const double longest = std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
    const double squared_radius = std::min(longest / 3, 1.0);
    const double margin = squared_radius / (1 + std::sqrt(1 - squared_radius)) + rounding;
    return {glm::min(a, glm::min(b, c)) - margin, glm::max(a, glm::max(b, c)) + margin};
}

std::vector<SpaceBox> cone_boxes_of(std::span<const Triangle> triangles, std::span<const glm::dvec3> points) {
    std::vector<SpaceBox> boxes;
    boxes.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) boxes.push_back(box_of(points[a], points[b], points[c]));
    return boxes;
}

std::vector<Triangle> neighbors_of(std::span<const Triangle> triangles, std::size_t vertex_count) {
    const HalfEdgeMesh mesh(static_cast<Index>(vertex_count), triangles);
    std::vector<Triangle> neighbors(triangles.size());
    for (Index t = 0; t < triangles.size(); ++t)
        for (Index corner = 0; corner < 3; ++corner)
            neighbors[t][corner] = mesh.twin(HalfEdgeMesh::on_side(t, corner)) / 3;
    return neighbors;
}

}  // namespace

SphereLocation::SphereLocation(std::span<const Triangle> triangles, std::span<const glm::dvec3> points)
    : triangles_(triangles),
      points_(points),
      neighbors_(neighbors_of(triangles, points.size())),
      tree_(cone_boxes_of(triangles, points)) {}

/// The coordinates of \p direction in the cone of a triangle, not normalized: side_of_arc() of the edges
/// opposite the corners.
glm::dvec3 SphereLocation::volumes(Index triangle, const glm::dvec3& direction) const {
    const auto& [a, b, c] = triangles_[triangle];
    return {side_of_arc(points_[b], points_[c], direction), side_of_arc(points_[c], points_[a], direction),
            side_of_arc(points_[a], points_[b], direction)};
}

MeshPoint SphereLocation::locate(const glm::dvec3& direction, Index guess) const {
    for (int steps = 0; guess != no_index && steps < max_steps; ++steps) {
        const glm::dvec3 inside = volumes(guess, direction);
        const glm::length_t farthest =
            inside.x <= inside.y ? (inside.x <= inside.z ? 0 : 2) : (inside.y <= inside.z ? 1 : 2);
        const double sum = inside.x + inside.y + inside.z;
        if (inside[farthest] >= 0 && sum > 0) return {guess, inside / sum};
        guess = neighbors_[guess][static_cast<std::size_t>(farthest)];
    }

    MeshPoint best;
    double best_least = -std::numeric_limits<double>::infinity();
    tree_.find(direction, [&](Index triangle) {
        const glm::dvec3 inside = volumes(triangle, direction);
        const double sum = inside.x + inside.y + inside.z;
        const double least = std::min({inside.x, inside.y, inside.z}) / sum;
        if (!(sum > 0 && least > best_least)) return false;
        best_least = least;
        const glm::dvec3 raised = glm::max(inside, glm::dvec3(0));
        best = {triangle, raised / (raised.x + raised.y + raised.z)};
        return least >= 0;
    });
    assert(best.triangle != no_index);
    return best;
}

}  // namespace interleaf
