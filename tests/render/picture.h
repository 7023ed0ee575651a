// A picture in memory and what the tests ask of one.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/renderer.h"

namespace interleaf {

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  ///< top row first

    bool operator==(const Picture&) const = default;

    /// The pixel in column \p x of row \p y from the top, as linear light.
    glm::vec3 light(int x, int y) const;
};

/// Draws and reads, and checks that OpenGL had nothing to complain of.
Picture take_picture(Renderer& renderer, OffscreenTarget& target, const Camera& camera,
                     std::span<const float> weights, const Display& display = {});

/// Number of pixels for which \p holds.
int count_pixels(const Picture& picture, const std::function<bool(glm::vec3 light)>& holds);

/// Number of pixels of which a component differs by more than \p tolerance of 255.
int count_differences(const Picture& a, const Picture& b, int tolerance = 0);

/// Mean over all pixels of the sum of the components.
double mean_brightness(const Picture& picture);

/// Where \p camera sees the world point \p point in \p picture, in pixels from the upper left.
glm::vec2 pixel_of(const Camera& camera, const Picture& picture, glm::vec3 point);

bool is_red(glm::vec3 light);
bool is_white(glm::vec3 light);
bool is_black(glm::vec3 light);

}  // namespace interleaf
