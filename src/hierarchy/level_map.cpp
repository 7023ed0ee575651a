#include "hierarchy/level_map.h"

namespace interleaf {

glm::dvec3 level_map(unsigned child, const glm::dvec3& b) {
    return child == 0 ? glm::dvec3(b.z, b.x / 2, b.x / 2 + b.y) : glm::dvec3(b.y, b.x / 2 + b.z, b.x / 2);
}

glm::dmat3 level_map(std::uint64_t path, unsigned level) {
    glm::dmat3 corners(1.0);
    while (level > 0) {
        --level;
        const auto child = static_cast<unsigned>(path >> level & 1);
        for (int c = 0; c < 3; ++c) corners[c] = level_map(child, corners[c]);
    }
    return corners;
}

}  // namespace interleaf
