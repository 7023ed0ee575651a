#include "hierarchy/color.h"

#include <cmath>

namespace interleaf {

glm::vec3 linear_light(glm::vec3 color) {
    for (int c = 0; c < 3; ++c)
        color[c] = color[c] <= 0.04045F ? color[c] / 12.92F : std::pow((color[c] + 0.055F) / 1.055F, 2.4F);
    return color;
}

glm::vec3 encoded(glm::vec3 light) {
    for (int c = 0; c < 3; ++c)
        light[c] =
            light[c] <= 0.0031308F ? 12.92F * light[c] : 1.055F * std::pow(light[c], 1 / 2.4F) - 0.055F;
    return light;
}

}  // namespace interleaf
