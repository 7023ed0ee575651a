// Where the panels are: computed by hand from the size of the window, so that it works at any.
#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "ui/widgets/rect.h"

namespace interleaf {

/// The rectangles share edges and cover the window below the menu bar.
struct Layout {
    std::optional<Rect> left;  ///< keys and display; a narrow window has them in the right column
    Rect view;
    Rect right;
    Rect timeline;  ///< without height where there is none to show
    Rect status;
};

/// \param size         of the window
/// \param menu_height  of the menu bar along the top
/// \param scale        of the user interface, 1 for an ordinary display
/// \param has_timeline whether there is a timeline to show
Layout lay_out(glm::vec2 size, float menu_height, float scale, bool has_timeline);

}  // namespace interleaf
