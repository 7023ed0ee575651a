// A picture in memory, and the measurements that tests take of it.
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

/// Draws and reads a picture, and checks that OpenGL reported no problem.
Picture take_picture(Renderer& renderer, OffscreenTarget& target, const Camera& camera,
                     std::span<const float> weights, const Display& display = {});

/// Number of pixels for which \p holds is true.
int count_pixels(const Picture& picture, const std::function<bool(glm::vec3 light)>& holds);

/// Number of pixels with a component that differs by more than \p tolerance of 255.
int count_differences(const Picture& a, const Picture& b, int tolerance = 0);

/// Mean over all pixels of the sum of the components.
double mean_brightness(const Picture& picture);

/// The place of the world point \p point in \p picture as seen by \p camera, in pixels from the upper left.
glm::vec2 pixel_of(const Camera& camera, const Picture& picture, glm::vec3 point);

bool is_red(glm::vec3 light);
bool is_white(glm::vec3 light);
bool is_black(glm::vec3 light);

}  // namespace interleaf
