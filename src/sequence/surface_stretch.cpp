#include "sequence/surface_stretch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace interleaf {

double stretch_of(std::span<const glm::dvec3, 3> before, std::span<const glm::dvec3, 3> now) {
    const glm::dvec3 side = before[1] - before[0];
    const glm::dvec3 other = before[2] - before[0];
    const double length = glm::length(side);
    const double height = length > 0 ? glm::length(glm::cross(side, other)) / length : 0;
    if (!(height > 0)) return 0;
    // The images of two unit vectors at right angles in the triangle before.
    const double along = glm::dot(side, other) / length;
    const glm::dvec3 u = (now[1] - now[0]) / length;
    const glm::dvec3 v = (now[2] - now[0] - along * u) / height;
    const double uu = glm::dot(u, u);
    const double vv = glm::dot(v, v);
    const double uv = glm::dot(u, v);
    return std::sqrt((uu + vv) / 2 + std::hypot((uu - vv) / 2, uv));
}

std::vector<float> vertex_stretches(std::span<const Triangle> triangles, std::span<const glm::dvec3> before,
                                    std::span<const glm::dvec3> now) {
    std::vector<double> sums(now.size());
    std::vector<double> areas(now.size());
    for (const auto& [a, b, c] : triangles) {
        const std::array corners_before = {before[a], before[b], before[c]};
        const std::array corners_now = {now[a], now[b], now[c]};
        const double area = glm::length(glm::cross(before[b] - before[a], before[c] - before[a]));
        const double stretch = stretch_of(corners_before, corners_now);
        for (const Index corner : {a, b, c}) {
            sums[corner] += area * stretch;
            areas[corner] += area;
        }
    }
    std::vector<float> stretches(now.size());
    std::transform(sums.begin(), sums.end(), areas.begin(), stretches.begin(),
                   [](double sum, double area) { return area > 0 ? static_cast<float>(sum / area) : 0.0F; });
    return stretches;
}

}  // namespace interleaf
