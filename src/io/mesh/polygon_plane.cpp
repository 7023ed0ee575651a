#include "io/mesh/polygon_plane.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace interleaf {
namespace {

/// An area below this fraction of the square of the polygon's size is a rounding error.
constexpr double negligible_area = 1e-12;

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The corners relative to the first corner, scaled by a power of two so that the largest coordinate is from
/// 1/2 to 1. Empty if all corners are equal.
std::vector<glm::dvec3> scaled_to_one(std::span<const glm::dvec3> corners) {
    // Halves, because the difference of two large numbers may overflow.
    std::vector<glm::dvec3> scaled;
    scaled.reserve(corners.size());
    double size = 0;
    for (const glm::dvec3& corner : corners) {
        scaled.push_back(corner / 2.0 - corners.front() / 2.0);
        size = std::max(size, largest(scaled.back()));
    }
    if (size == 0) return {};
    int exponent = 0;
    std::frexp(size, &exponent);
    for (glm::dvec3& corner : scaled)
        corner = {std::ldexp(corner.x, -exponent), std::ldexp(corner.y, -exponent),
                  std::ldexp(corner.z, -exponent)};
    return scaled;
}

/// Twice the area vector. If two halves of the polygon cancel, as in a figure of eight, the normal of the
/// largest triangle at the first corner.
glm::dvec3 normal_of(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum += glm::cross(corners[i], corners[i + 1]);
    if (largest(sum) > negligible_area) return sum;
    const auto farthest = std::max_element(
        corners.begin(), corners.end(),
        [](const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a, a) < glm::dot(b, b); });
    glm::dvec3 normal(0);
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 across = glm::cross(*farthest, corner);
        if (largest(across) > largest(normal)) normal = across;
    }
    return normal;
}

/// Two axes perpendicular to \p normal. If the normal runs along an axis of space, they are the other two
/// axes.
std::array<glm::dvec3, 2> axes_across(const glm::dvec3& normal) {
    const glm::dvec3 part = glm::abs(normal);
    const int least = part.x <= part.y && part.x <= part.z ? 0 : part.y <= part.z ? 1 : 2;
    glm::dvec3 axis(0);
    axis[least] = 1;
    const glm::dvec3 unit = glm::normalize(normal);
    const glm::dvec3 second = glm::normalize(glm::cross(unit, axis));
    return {glm::cross(second, unit), second};
}

}  // namespace

PlanePolygon in_plane(std::span<const glm::dvec3> corners) {
    const std::vector<glm::dvec3> scaled = scaled_to_one(corners);
    if (scaled.empty()) return {};
    const glm::dvec3 normal = normal_of(scaled);
    if (!(largest(normal) > negligible_area)) return {};
    const auto [x_axis, y_axis] = axes_across(normal);

    std::vector<glm::dvec2> flat;
    flat.reserve(scaled.size());
    glm::dvec3 middle(0);
    for (const glm::dvec3& corner : scaled) {
        flat.emplace_back(glm::dot(corner, x_axis), glm::dot(corner, y_axis));
        middle += corner / static_cast<double>(scaled.size());
    }
    glm::dvec2 least = flat.front();
    glm::dvec2 most = flat.front();
    for (const glm::dvec2& point : flat) {
        least = glm::min(least, point);
        most = glm::max(most, point);
    }
    const glm::dvec2 sides = most - least;
    const double side = std::max(sides.x, sides.y);

    PlanePolygon polygon;
    polygon.points.reserve(flat.size());
    for (const glm::dvec2& point : flat) {
        const glm::dvec2 place = (point - least) * (static_cast<double>(plane_steps) / side);
        polygon.points.push_back({std::llround(place.x), std::llround(place.y)});
    }
    const glm::dvec3 unit = glm::normalize(normal);
    for (const glm::dvec3& corner : scaled)
        polygon.bulge = std::max(polygon.bulge, std::abs(glm::dot(corner - middle, unit)) / side);
    return polygon;
}

}  // namespace interleaf
