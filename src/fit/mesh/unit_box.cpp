#include "fit/mesh/unit_box.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace interleaf {

std::vector<glm::dvec3> in_unit_box(std::span<const glm::dvec3> positions) {
    if (positions.empty()) return {};
    glm::dvec3 least = positions.front();
    glm::dvec3 largest = least;
    for (const glm::dvec3& position : positions) {
        least = glm::min(least, position);
        largest = glm::max(largest, position);
    }
    const glm::dvec3 sides = largest - least;
    int exponent = 0;
    std::frexp(std::max({sides.x, sides.y, sides.z}), &exponent);

    std::vector<glm::dvec3> scaled;
    scaled.reserve(positions.size());
    for (const glm::dvec3& position : positions) {
        const glm::dvec3 offset = position - least;
        scaled.emplace_back(std::ldexp(offset.x, -exponent), std::ldexp(offset.y, -exponent),
                            std::ldexp(offset.z, -exponent));
    }
    return scaled;
}

}  // namespace interleaf
