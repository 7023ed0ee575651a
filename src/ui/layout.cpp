#include "ui/layout.h"

#include <algorithm>
#include <cmath>

namespace interleaf {

namespace {

/// Lengths at scale 1.
constexpr float narrow = 960;
constexpr float usual_column_width = 256;
constexpr float min_column_width = 180;
constexpr float max_left_width = 340;
constexpr float max_right_width = 560;
constexpr float first_wide = 1280;
constexpr float min_timeline_height = 64;
constexpr float status_height = 26;

/// A low window shows no curves of weights.
float usual_timeline_height(float height) {
    return height >= 620 ? 160 : 104;
}

}  // namespace

Layout lay_out(glm::vec2 size, float menu_height, float scale, bool has_timeline, float plots_height,
               const PanelSizes& wanted) {
    const auto pixels = [scale](float length) { return std::round(length * scale); };
    const glm::vec2 usual = size / scale;

    const float status_top = std::max(size.y - pixels(status_height), menu_height);
    float timeline_height = 0;
    if (has_timeline) {
        timeline_height = pixels(usual_timeline_height(usual.y) + plots_height);
        if (wanted.timeline)
            timeline_height = std::min(pixels(std::max(*wanted.timeline, min_timeline_height + plots_height)),
                                       std::floor(size.y * 0.45F));
    }
    const float timeline_top = std::max(status_top - timeline_height, menu_height);
    const float middle_height = timeline_top - menu_height;

    // The surface always keeps part of the width.
    const bool has_left = size.x >= pixels(narrow);
    const float most = std::floor(size.x * (has_left ? 0.35F : 0.45F));
    const auto column_of = [&](const std::optional<float>& chosen, float growth, float max_width) {
        // In a wide window, a column gets part of the width.
        const float width = usual_column_width + growth * (usual.x - first_wide);
        const float length =
            chosen ? std::max(*chosen, min_column_width) : std::clamp(width, usual_column_width, max_width);
        return std::min(pixels(length), most);
    };
    const float left = column_of(wanted.left, 0.05F, max_left_width);
    const float right = column_of(wanted.right, 0.25F, max_right_width);

    Layout layout;
    float view_left = 0;
    if (has_left) {
        layout.left = Rect{0, menu_height, left, middle_height};
        view_left = left;
    }
    layout.view = {view_left, menu_height, size.x - right - view_left, middle_height};
    layout.right = {size.x - right, menu_height, right, middle_height};
    layout.timeline = {0, timeline_top, size.x, status_top - timeline_top};
    layout.status = {0, status_top, size.x, std::max(size.y - status_top, 0.0F)};
    return layout;
}

}  // namespace interleaf
