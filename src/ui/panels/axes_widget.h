// The axes of space in a corner of the view, as the camera sees them. A click on the end of an axis looks along it, a
// drag turns.
#pragma once

#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "ui/widgets/rect.h"

namespace interleaf {

struct AxesResult {
    std::optional<glm::vec3> look_from{};  ///< the end of an axis to look from, if one was clicked
    glm::vec2 orbit{0};  ///< movement of the pointer in a drag, in units of the view's height, y down
};

/// The rectangle of the widget in \p view; none if the view is too small for it.
std::optional<Rect> axes_place(const Rect& view);

/// Shows the axes in the upper right corner of \p view, if it is large enough.
/// Call it before view_area(), so that the pointer finds the axes first.
/// \param axes    of the camera: right, up and backward, as columns
/// \param window  the name of the view area
AxesResult axes_widget(const Rect& view, const glm::mat3& axes, const char* window = "view");

}  // namespace interleaf
