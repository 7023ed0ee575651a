// The refine brush over the surface in the window: turns the mouse into rays, and shows the circle of the brush.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "app/brushing/brush_stroke.h"
#include "app/document/viewer_state.h"
#include "app/window/surface_view.h"
#include "ui/gui.h"
#include "ui/panels/brush_bar.h"
#include "ui/widgets/rect.h"

namespace interleaf {

class SurfaceBrush {
  public:
    /// Applies \p input, which was read over \p view, to the key that \p surface shows.
    /// \param now  wall time, seconds
    void apply(const BrushResult& input, ViewerState& state, const SurfaceView& surface, const Rect& view,
               double now);

    /// Draws the circle of the brush where the pointer is over the surface.
    /// \pre SurfaceView::draw() has been called in this frame
    void draw(const ViewerState& state, SurfaceView& surface, const Rect& view, const Gui& gui);

    /// Whether the pointer was over the surface in the last draw().
    bool is_over_surface() const { return under_pointer_.has_value(); }

  private:
    BrushStroke stroke_;
    std::optional<glm::vec3> under_pointer_;
};

}  // namespace interleaf
