#include "app/window/frame_layout.h"

#include "ui/panels/menu_bar.h"
#include "ui/timeline/blend_plots.h"

namespace interleaf {

FrameLayout frame_layout(const ViewerState& state, glm::vec2 size, float scale) {
    const float menu = menu_bar_height();
    FrameLayout frame;
    frame.window = size;
    frame.content = {0, menu, frame.window.x, frame.window.y - menu};
    frame.panels = lay_out(frame.window, menu, scale, state.session.has_time(),
                           state.plots_blend ? blend_plots_height : 0);
    return frame;
}

}  // namespace interleaf
