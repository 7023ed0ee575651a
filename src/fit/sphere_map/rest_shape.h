// The rest shape of a triangle on the surface, as cotangents. They measure how far another triangle is from
// similar.
#pragma once

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace interleaf {

/// The cotangents of the angles opposite the sides a b, b c, c a of a triangle. The triangle is first blended
/// towards equilateral by \p blend, in (0, 1], so that needles and triangles without area do not demand the
/// impossible.
inline std::array<double, 3> rest_cotangents(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                             double blend) {
    std::array<double, 3> squared = {glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)};
    double mean = (squared[0] + squared[1] + squared[2]) / 3;
    if (!(mean > 0)) mean = blend = 1;
    for (double& side : squared) side = (1 - blend) * side / mean + blend;
    const auto [u, v, w] = squared;
    const double four_areas = std::sqrt(2 * (u * v + v * w + w * u) - (u * u + v * v + w * w));
    for (double& side : squared) side = (3 - 2 * side) / four_areas;
    return squared;
}

}  // namespace interleaf
