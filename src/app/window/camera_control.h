// What the mouse does in a view of a surface, done to the camera.
#pragma once

#include "render/camera.h"
#include "render/offscreen_target.h"
#include "ui/panels/view_area.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// A point of the window in \p view's normalized device coordinates, -1 to 1, y up.
glm::vec2 device_coordinates(const Rect& view, glm::vec2 point);

/// Width over height.
float aspect_of(const Rect& view);

/// Turns and shifts \p camera; comes nearer to what is under the pointer in \p picture, which fills \p view;
/// null for no picture yet. The caller handles `view_all`.
void move_camera(Camera& camera, const ViewInput& input, const Rect& view, OffscreenTarget* picture);

}  // namespace interleaf
