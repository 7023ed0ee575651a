// What the person did in the panels becomes a step of the document, or moves the session.
#pragma once

#include "app/document/viewer_state.h"
#include "app/window/window_panels.h"

namespace interleaf {

/// Applies \p actions, done in panels that showed \p state, at wall time \p now.
/// What the mouse holds is kept in \p holds for the next frame. The camera, files to open and the comparison
/// are left to the caller.
/// \pre \p state is as the panels showed it, but for the time
void apply(const WindowActions& actions, ViewerState& state, MouseHolds& holds, double now);

}  // namespace interleaf
