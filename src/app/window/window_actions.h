// Applies the user's actions in the panels to the document and the session.
#pragma once

#include "app/document/viewer_state.h"
#include "app/window/window_panels.h"

namespace interleaf {

/// Applies \p actions at wall time \p now. The caller applies the actions on the camera, on files to open and
/// on the comparison.
/// \param holds  receives the objects that the mouse holds, for the next frame
/// \pre the panels that returned \p actions showed \p state; only its time may have changed since
void apply_to_state(const WindowActions& actions, ViewerState& state, MouseHolds& holds, double now);

}  // namespace interleaf
