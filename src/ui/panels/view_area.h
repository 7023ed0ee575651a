// The area in which the surface is seen: what the mouse does there, as wishes for the camera.
#pragma once

#include <glm/vec2.hpp>

#include "ui/widgets/rect.h"

namespace interleaf {

struct ViewInput {
    glm::vec2 orbit{0};       ///< the pointer's way, in units of the area's height, y down
    glm::vec2 pan{0};         ///< the same
    float zoom = 1;           ///< factor, above 1 nearer
    glm::vec2 pointer{0};     ///< window coordinates
    bool view_all = false;    ///< see the whole model
    bool pointed_at = false;  ///< the pointer rests or moves over the area, and drags nothing
};

/// Left drag orbits; right, middle and Shift + left drag pan; the wheel zooms; a double click views the whole
/// model.
/// \param name  unique in the frame
ViewInput view_area(const Rect& rect, const char* name = "view");

}  // namespace interleaf
