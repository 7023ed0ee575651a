// The layout of one frame: the places of the window's parts, in screen coordinates of the window.
#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "app/document/viewer_state.h"
#include "ui/layout.h"
#include "ui/widgets/rect.h"

namespace interleaf {

struct FrameLayout {
    glm::vec2 window{0};           ///< size
    Rect content;                  ///< everything below the menu bar
    Layout panels;                 ///< of the document
    Rect view;                     ///< of the surface; or of a comparison, with both surfaces and their panel
    Rect keys;                     ///< the visible rows of keys
    std::optional<Rect> domain;    ///< the bounding box of the domain's vertices
    std::optional<Rect> timeline;  ///< the track from begin to end
};

/// The layout of \p state in a window of \p size, before its panels are shown.
/// \param scale  of the user interface
FrameLayout frame_layout(const ViewerState& state, glm::vec2 size, float scale);

}  // namespace interleaf
