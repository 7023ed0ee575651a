#include "shapes/leaf_fit.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace interleaf {
namespace {

constexpr unsigned divisions = 4;

constexpr unsigned grid_place(unsigned row, unsigned column) {
    return row * (row + 1) / 2 + column;
}

std::vector<glm::dvec3> flat_grid(const std::array<glm::dvec3, 3>& corners, unsigned parts) {
    const auto& [a, b, c] = corners;
    std::vector<glm::dvec3> points;
    points.reserve(grid_place(parts + 1, 0));
    for (unsigned row = 0; row <= parts; ++row) {
        for (unsigned column = 0; column <= row; ++column) {
            points.push_back((double(parts - row) * a + double(row - column) * b + double(column) * c) /
                             double(parts));
        }
    }
    return points;
}

double distance_to_segment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
    const double squared_length = glm::dot(b - a, b - a);
    const double t =
        squared_length > 0 ? glm::clamp(glm::dot(point - a, b - a) / squared_length, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + t * (b - a));
}

/// The unit normal; zero for a triangle of no area.
glm::dvec3 unit_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : glm::dvec3(0);
}

double max_turn(std::span<const glm::dvec3> samples, const glm::dvec3& leaf_normal) {
    double turn = 0;
    const auto compare = [&](unsigned a, unsigned b, unsigned c) {
        turn = std::max(turn, glm::distance(leaf_normal, unit_normal(samples[a], samples[b], samples[c])));
    };
    for (unsigned row = 0; row < divisions; ++row) {
        for (unsigned column = 0; column <= row; ++column) {
            compare(grid_place(row, column), grid_place(row + 1, column), grid_place(row + 1, column + 1));
            if (column < row)
                compare(grid_place(row, column), grid_place(row + 1, column + 1),
                        grid_place(row, column + 1));
        }
    }
    return turn;
}

}  // namespace

std::vector<glm::dvec3> base_grid(const BaseSurface& base, const std::array<glm::dvec3, 3>& corners,
                                  unsigned parts) {
    std::vector<glm::dvec3> points = flat_grid(corners, parts);
    for (glm::dvec3& point : points) point = base.project(point);
    return points;
}

double distance_to_triangle(const glm::dvec3& point, const std::array<glm::dvec3, 3>& corners) {
    const auto& [a, b, c] = corners;
    const glm::dvec3 normal = unit_normal(a, b, c);
    const auto is_left_of = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return glm::dot(glm::cross(to - from, point - from), normal) >= 0;
    };
    if (normal != glm::dvec3(0) && is_left_of(a, b) && is_left_of(b, c) && is_left_of(c, a)) {
        return std::abs(glm::dot(point - a, normal));
    }
    return std::min({distance_to_segment(point, a, b), distance_to_segment(point, b, c),
                     distance_to_segment(point, c, a)});
}

LeafFit measure_fit(const BaseSurface& base, const Surface& surface,
                    const std::array<glm::dvec3, 3>& base_corners) {
    std::vector<glm::dvec3> samples = base_grid(base, base_corners, divisions);
    for (glm::dvec3& sample : samples) sample = surface(sample);

    const std::array<glm::dvec3, 3> corners = {samples[grid_place(0, 0)], samples[grid_place(divisions, 0)],
                                               samples[grid_place(divisions, divisions)]};
    const auto& [a, b, c] = corners;
    const std::vector<glm::dvec3> flat = flat_grid(corners, divisions);
    LeafFit fit{0, 0, max_turn(samples, unit_normal(a, b, c)),
                std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)})};
    for (std::size_t i = 0; i < samples.size(); ++i) {
        fit.distance = std::max(fit.distance, distance_to_triangle(samples[i], corners));
        fit.apart = std::max(fit.apart, glm::distance(samples[i], flat[i]));
    }
    return fit;
}

}  // namespace interleaf
