#include "fit/sampling/leaf_faults.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace interleaf {

double cosine_of_degrees(double degrees) {
    return std::cos(degrees * std::numbers::pi / 180);
}

double max_cosine(const TriangleCorners& corners) {
    double largest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 a = corners[(i + 1) % 3] - corners[i];
        const glm::dvec3 b = corners[(i + 2) % 3] - corners[i];
        const double lengths = std::sqrt(glm::dot(a, a) * glm::dot(b, b));
        if (!(lengths > 0)) return 1;
        largest = std::max(largest, glm::dot(a, b) / lengths);
    }
    return largest;
}

TriangleCorners corners_of(const Triangle& leaf, const SampledSurface& surface) {
    const auto& [a, b, c] = leaf;
    return {surface.positions[a], surface.positions[b], surface.positions[c]};
}

std::size_t count_needles(const SampledSurface& surface, double degrees) {
    const double cosine = cosine_of_degrees(degrees);
    return static_cast<std::size_t>(std::ranges::count_if(surface.leaves, [&](const Leaf& leaf) {
        return max_cosine(corners_of(leaf.vertices, surface)) > cosine;
    }));
}

std::size_t count_faulty_leaves(const MappedSurface& mapped, const SampledSurface& surface) {
    const double good_cosine = cosine_of_degrees(smoothed_angle);
    return static_cast<std::size_t>(std::ranges::count_if(surface.leaves, [&](const Leaf& leaf) {
        return max_cosine(corners_of(leaf.vertices, surface)) > good_cosine ||
               faces_away(leaf.vertices, surface, mapped);
    }));
}

}  // namespace interleaf
