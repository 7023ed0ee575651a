// The layout of one frame: the places of the window's parts, in screen coordinates of the window.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "app/document/viewer_state.h"
#include "ui/layout.h"
#include "ui/widgets/rect.h"

namespace interleaf {

struct FrameLayout {
    glm::vec2 window{0};           ///< size
    float scale = 1;               ///< of the user interface
    Rect content;                  ///< everything below the menu bar
    Layout panels;                 ///< of the document
    Rect view;                     ///< of the surface; or of a comparison, with both surfaces and their panel
    std::vector<Rect> key_views;   ///< of the pictures of active keys beside the surface; may be none
    Rect keys;                     ///< the visible rows of keys
    std::optional<Rect> domain;    ///< the bounding box of the domain's vertices
    std::optional<Rect> timeline;  ///< the track from begin to end
};

/// The layout of \p state in a window of the size \p window.
/// \param menu_height  height of the menu bar
/// \param scale        scale of the user interface
FrameLayout lay_out_frame(glm::vec2 window, float menu_height, float scale, const ViewerState& state);

}  // namespace interleaf
