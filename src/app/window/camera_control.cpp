#include "app/window/camera_control.h"

#include <algorithm>

#include <glm/common.hpp>

namespace interleaf {

namespace {

void zoom(Camera& camera, const ViewInput& input, const Rect& view, OffscreenTarget* picture) {
    const glm::vec2 pointer = device_coordinates(view, input.pointer);
    const glm::vec2 part{(pointer.x + 1) / 2, (1 - pointer.y) / 2};
    const auto pixel = [](float place, int count) {
        return std::clamp(static_cast<int>(place * static_cast<float>(count)), 0, count - 1);
    };
    const float depth = picture != nullptr ? picture->depth_at(pixel(part.x, picture->width()),
                                                               pixel(part.y, picture->height()))
                                           : 1;
    if (depth < 1)
        camera.approach(input.zoom, camera.point_at(pointer, depth, aspect_of(view)));
    else
        camera.zoom(input.zoom, pointer, aspect_of(view));
}

}  // namespace

glm::vec2 device_coordinates(const Rect& view, glm::vec2 point) {
    return {2 * (point.x - view.x) / view.width - 1, 1 - 2 * (point.y - view.y) / view.height};
}

glm::ivec2 pixels_of(const Rect& view, float density) {
    return glm::max(glm::ivec2(glm::round(density * glm::vec2(view.width, view.height))), 1);
}

float aspect_of(const Rect& view) {
    return view.width / std::max(view.height, 1.0F);
}

void move_camera(Camera& camera, const ViewInput& input, OrbitStyle style, const Rect& view,
                 OffscreenTarget* picture) {
    camera.orbit(input.orbit, style);
    if (input.roll != 0) camera.roll(input.roll);
    camera.pan(input.pan);
    if (input.zoom != 1) zoom(camera, input, view, picture);
}

}  // namespace interleaf
