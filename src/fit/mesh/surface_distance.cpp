#include "fit/mesh/surface_distance.h"

#include <cmath>
#include <vector>

#include "fit/mesh/space_triangle.h"

namespace interleaf {
namespace {

std::vector<SpaceBox> boxes_of(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions) {
    std::vector<SpaceBox> boxes;
    boxes.reserve(triangles.size());
    for (const auto& [i, j, k] : triangles) {
        const glm::dvec3 &a = positions[i], &b = positions[j], &c = positions[k];
        boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
    }
    return boxes;
}

}  // namespace

SurfaceDistance::SurfaceDistance(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions)
    : triangles_(triangles), positions_(positions), tree_(boxes_of(triangles, positions)) {}

double SurfaceDistance::squared_distance(const glm::dvec3& point, Index triangle) const {
    const auto& [a, b, c] = triangles_[triangle];
    return squared_distance_to_triangle(point, {positions_[a], positions_[b], positions_[c]});
}

double SurfaceDistance::operator()(const glm::dvec3& point, Index& nearest, double enough) const {
    if (nearest == no_index) nearest = 0;
    double least = squared_distance(point, nearest);
    tree_.find_nearest(point, least, enough * enough, [&](Index triangle) {
        const double distance = squared_distance(point, triangle);
        if (distance < least) nearest = triangle;
        return distance;
    });
    return std::sqrt(least);
}

}  // namespace interleaf
