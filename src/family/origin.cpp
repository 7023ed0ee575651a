#include "family/origin.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace interleaf {

glm::dvec3 origin_for(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles) {
    constexpr double max_diagonals = 100;
    constexpr double min_gain = 10;
    glm::dvec3 least(std::numeric_limits<double>::infinity());
    glm::dvec3 most = -least;
    for (const Triangle& triangle : triangles)
        for (const Index vertex : triangle) {
            least = glm::min(least, positions[vertex]);
            most = glm::max(most, positions[vertex]);
        }
    if (triangles.empty()) return glm::dvec3(0);
    const glm::dvec3 center = least / 2.0 + most / 2.0;
    const double distance = glm::length(center);
    if (!(distance > max_diagonals * glm::distance(least, most)) || !std::isfinite(distance))
        return glm::dvec3(0);
    const glm::dvec3 origin = glm::round(center);
    return glm::distance(origin, center) * min_gain < distance ? origin : glm::dvec3(0);
}

std::string origin_sentence(const glm::dvec3& origin) {
    return fmt::format("Far from 0: ({}, {}, {}) was subtracted from all positions.", origin.x, origin.y,
                       origin.z);
}

void move_origin(std::vector<Key>& keys, const glm::dvec3& from, const glm::dvec3& to) {
    if (from == to) return;
    const glm::dvec3 offset = from - to;
    for (Key& key : keys) {
        Hierarchy moved = *key.hierarchy;
        for (glm::vec3& position : moved.positions) position = glm::vec3(glm::dvec3(position) + offset);
        key.hierarchy = std::move(moved);
    }
}

}  // namespace interleaf
