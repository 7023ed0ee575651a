#include "ui/layout.h"

#include <algorithm>
#include <cmath>

namespace interleaf {

Layout lay_out(glm::vec2 size, float menu_height, float scale, bool has_timeline, float plots_height) {
    constexpr float narrow = 960;
    constexpr float column_width = 248;
    constexpr float first_wide = 1280;
    constexpr float max_right_width = 420;
    // A low window shows no curves of weights.
    const float timeline_height = (size.y >= 620 * scale ? 160 : 104) + plots_height;
    constexpr float status_height = 26;
    const auto pixels = [scale](float length) { return std::round(length * scale); };

    const float status_top = std::max(size.y - pixels(status_height), menu_height);
    const float timeline_top = std::max(status_top - pixels(has_timeline ? timeline_height : 0), menu_height);
    const float middle_height = timeline_top - menu_height;
    // The surface always keeps part of the width.
    const auto column_of = [&](float width) { return std::min(pixels(width), std::floor(size.x * 0.45F)); };
    const float column = column_of(column_width);
    // In a wide window, the right column gets part of the width, so that the parameter domain grows.
    const float right = column_of(
        std::clamp(column_width + 0.25F * (size.x / scale - first_wide), column_width, max_right_width));

    Layout layout;
    float view_left = 0;
    if (size.x >= pixels(narrow)) {
        layout.left = Rect{0, menu_height, column, middle_height};
        view_left = column;
    }
    layout.view = {view_left, menu_height, size.x - right - view_left, middle_height};
    layout.right = {size.x - right, menu_height, right, middle_height};
    layout.timeline = {0, timeline_top, size.x, status_top - timeline_top};
    layout.status = {0, status_top, size.x, std::max(size.y - status_top, 0.0F)};
    return layout;
}

}  // namespace interleaf
