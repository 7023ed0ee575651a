#include "render/straight_alpha.h"

#include <cassert>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "hierarchy/color.h"

namespace interleaf {

void make_alpha_straight(std::span<std::uint8_t> rgba) {
    assert(rgba.size() % 4 == 0);
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        const std::uint8_t alpha = rgba[i + 3];
        if (alpha == 0 || alpha == 255) continue;
        const glm::vec3 multiplied = linear_light(glm::vec3(rgba[i], rgba[i + 1], rgba[i + 2]) / 255.0F);
        const glm::vec3 light = glm::min(multiplied * (255.0F / static_cast<float>(alpha)), 1.0F);
        const glm::vec3 color = glm::round(255.0F * encoded(light));
        for (int c = 0; c < 3; ++c)
            rgba[i + static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(color[c]);
    }
}

}  // namespace interleaf
