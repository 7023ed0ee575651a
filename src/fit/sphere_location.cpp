#include "fit/sphere_location.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace interleaf {
namespace {

/// Boxes are larger by this, so that rounding leaves no direction outside all of them.
constexpr double rounding = 1e-12;

/// A box of the spherical triangle with these corners.
///
/// It bulges out of the flat triangle by 1 - |q| at most, q the flat triangle's point nearest to the origin.
/// q is a mean of the corners with some weights, so |q|^2 is 1 less their mean squared distance from q, which
/// is at most the square of the radius of a ball around the triangle: a third of its squared longest edge
/// (Jung 1901).
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

}  // namespace

SphereLocation::SphereLocation(std::span<const Triangle> triangles, std::span<const glm::dvec3> points)
    : triangles_(triangles), points_(points), tree_(cone_boxes_of(triangles, points)) {}

SphereLocation::Candidate SphereLocation::in_triangle(Index triangle, const glm::dvec3& direction) const {
    const auto& [a, b, c] = triangles_[triangle];
    const glm::dvec3 volumes(side_of_arc(points_[b], points_[c], direction),
                             side_of_arc(points_[c], points_[a], direction),
                             side_of_arc(points_[a], points_[b], direction));
    const double sum = volumes.x + volumes.y + volumes.z;
    if (!(sum > 0)) return {{}, -std::numeric_limits<double>::infinity()};
    const glm::dvec3 inside = glm::max(volumes, glm::dvec3(0));
    return {{triangle, inside / (inside.x + inside.y + inside.z)},
            std::min({volumes.x, volumes.y, volumes.z}) / sum};
}

MeshPoint SphereLocation::locate(const glm::dvec3& direction, Index guess) const {
    if (guess != no_index) {
        const Candidate candidate = in_triangle(guess, direction);
        if (candidate.least >= 0) return candidate.point;
    }
    Candidate best{{}, -std::numeric_limits<double>::infinity()};
    tree_.find(direction, [&](Index triangle) {
        const Candidate candidate = in_triangle(triangle, direction);
        if (candidate.least > best.least) best = candidate;
        return best.least >= 0;
    });
    assert(best.point.triangle != no_index);
    return best.point;
}

}  // namespace interleaf
