#include "app/window/frame_layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ui/timeline/blend_plots.h"

namespace interleaf {

namespace {

constexpr std::size_t max_key_views = 6;
constexpr float min_divided_width = 320;  // at scale 1

/// Divides the view into that of the surface and a column with a picture of each active key.
void add_key_views(FrameLayout& frame, std::size_t active_keys, float scale) {
    Rect& view = frame.panels.view;
    if (view.width < min_divided_width * scale || view.height < 1) return;
    const std::size_t count = std::min(active_keys, max_key_views);
    const float width = std::round(std::clamp(0.28F * view.width, 110 * scale, 280 * scale));
    view.width -= width;
    // A picture that is narrower than that of the surface would cut its sides off.
    const float tallest = width * view.height / view.width;
    const float height = std::floor(std::min(view.height / static_cast<float>(count), tallest));
    for (std::size_t n = 0; n < count; ++n)
        frame.key_views.push_back({view.right(), view.y + height * static_cast<float>(n), width, height});
}

}  // namespace

FrameLayout lay_out_frame(glm::vec2 window, float menu_height, float scale, const ViewerState& state) {
    FrameLayout frame;
    frame.window = window;
    frame.content = {0, menu_height, window.x, window.y - menu_height};
    frame.scale = scale;
    frame.panels = lay_out(window, menu_height, scale, state.session.has_time(),
                           state.plots_blend ? blend_plots_height : 0, state.appearance.panels);
    if (state.shows_keys_beside && !state.is_comparing)
        add_key_views(frame, state.session.weights().size(), scale);
    return frame;
}

}  // namespace interleaf
