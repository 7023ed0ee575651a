#include "app/window/frame_layout.h"

#include "ui/timeline/blend_plots.h"

namespace interleaf {

FrameLayout lay_out_frame(glm::vec2 window, float menu_height, float scale, const ViewerState& state) {
    FrameLayout frame;
    frame.window = window;
    frame.content = {0, menu_height, window.x, window.y - menu_height};
    frame.scale = scale;
    frame.panels = lay_out(window, menu_height, scale, state.session.has_time(),
                           state.plots_blend ? blend_plots_height : 0, state.appearance.panels);
    return frame;
}

}  // namespace interleaf
