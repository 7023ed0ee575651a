// T. Moeller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal of Graphics Tools 2(1),
// 1997.
#include "render/pick.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace interleaf {

namespace {

/// A ray through an edge must not slip between its two triangles.
constexpr float slack = 1e-5F;

}  // namespace

std::optional<Hit> first_hit(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                             const Ray& ray) {
    const glm::vec3 direction = ray.to - ray.from;
    std::optional<Hit> first;
    float nearest = 1;  // fraction of the ray
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        const glm::vec3 to_b = positions[b] - positions[a];
        const glm::vec3 to_c = positions[c] - positions[a];
        const glm::vec3 across = glm::cross(direction, to_c);
        const float determinant = glm::dot(to_b, across);
        const glm::vec3 from_a = ray.from - positions[a];
        const float at_b = glm::dot(from_a, across);
        // The ray misses most triangles, and this test rejects most of those, before any division.
        const float least = -slack * std::abs(determinant);
        const float sign = determinant < 0 ? -1.0F : 1.0F;
        if (determinant == 0 || sign * at_b < least || sign * at_b > std::abs(determinant) - least) continue;
        const glm::vec3 normal = glm::cross(from_a, to_b);
        const float at_c = glm::dot(direction, normal);
        if (sign * at_c < least || sign * (at_b + at_c) > std::abs(determinant) - least) continue;
        const float way = glm::dot(to_c, normal) / determinant;
        if (!(way >= 0 && way <= nearest)) continue;
        nearest = way;
        const float v = at_b / determinant;
        const float w = at_c / determinant;
        first = Hit{t, {1 - v - w, v, w}};
    }
    return first;
}

}  // namespace interleaf
