// The places of the panels, computed from the size of the window. The layout works at any size.
#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "ui/widgets/appearance.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// The rectangles share edges and cover the window below the menu bar.
struct Layout {
    std::optional<Rect> left;  ///< keys and display; none in a narrow window, which has them at the right
    Rect view;
    Rect right;
    Rect timeline;  ///< height 0 if there is no timeline
    Rect status;
};

/// \param size  size of the window
/// \param menu_height  height of the menu bar along the top
/// \param scale  scale of the user interface; 1 for an ordinary display
/// \param has_timeline  whether there is a timeline to show
/// \param plots_height  of the plots below the timeline, at scale 1; 0 for none
/// \param wanted  sizes that the user has chosen; the surface keeps its part of the window all the same
Layout lay_out(glm::vec2 size, float menu_height, float scale, bool has_timeline, float plots_height = 0,
               const PanelSizes& wanted = {});

}  // namespace interleaf
