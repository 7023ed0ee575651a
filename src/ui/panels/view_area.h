// The area that shows the surface: the mouse input in it, as movements of the camera.
#pragma once

#include <glm/vec2.hpp>

#include "ui/widgets/rect.h"

namespace interleaf {

struct ViewInput {
    glm::vec2 orbit{0};       ///< movement of the pointer, in units of the area's height, y down
    glm::vec2 pan{0};         ///< in the same units
    float roll = 0;           ///< of the picture about its center, counterclockwise, degrees
    float zoom = 1;           ///< factor; above 1 moves nearer
    glm::vec2 pointer{0};     ///< window coordinates
    bool view_all = false;    ///< show the whole model: a double-click in one place
    bool pointed_at = false;  ///< the pointer is over the area, and drags nothing
    bool clicked = false;     ///< the left button was pressed and released in one place, once
    bool hovered = false;     ///< the pointer is over the area, whatever it drags there
    bool pressed = false;     ///< the left button went down over the area in this frame
    bool pressed_again =
        false;                ///< that was the second press of a double-click, if it does not become a drag
    bool held = false;        ///< the left button has been down since
    bool turns_flat = false;  ///< Ctrl is held: a drag also orbits a flat surface, which it pans otherwise
};

/// Reads the mouse in the area. A left drag orbits (or pans a flat surface, see turns_flat); a right drag, a middle
/// drag and Shift + left drag pan; Ctrl + right drag rolls; the wheel zooms; a double-click shows the whole model.
/// \param name  unique in the frame
ViewInput view_area(const Rect& rect, const char* name = "view");

}  // namespace interleaf
