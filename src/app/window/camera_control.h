// Moves the camera by the mouse input in a view of a surface.
#pragma once

#include <glm/vec2.hpp>

#include "render/camera.h"
#include "render/offscreen_target.h"
#include "ui/panels/view_area.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// The normalized device coordinates in \p view, -1 to 1, y up, of a point of the window.
glm::vec2 device_coordinates(const Rect& view, glm::vec2 point);

/// The size of the picture in \p view, at least 1 pixel.
/// \param density  framebuffer pixels per screen coordinate
glm::ivec2 pixels_of(const Rect& view, float density);

/// Width over height.
float aspect_of(const Rect& view);

/// Turns, rolls, shifts and zooms \p camera. Zooming moves the camera toward the surface point under the pointer.
/// The caller handles `view_all`.
/// \param picture  fills \p view and shows which surface point is under the pointer; null if there is none
///     yet
void move_camera(Camera& camera, const ViewInput& input, OrbitStyle style, const Rect& view,
                 OffscreenTarget* picture);

}  // namespace interleaf
