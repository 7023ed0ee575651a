// The commands on the path through the parameter domain: recording, smoothing, removing, and the choice of
// whether keys or the path drive. Each change of the family is an undoable step of the document.
#pragma once

#include "app/document/viewer_state.h"

namespace interleaf {

/// Begins to record a path, or ends it: the dragged points, with few points where few suffice, become the path
/// of the family, which then drives. Without two points the family stays as it is.
void toggle_recording(ViewerState& state, double now);

/// Adds the present point of the session to the recording, if one goes on.
void record_point(ViewerState& state, double now);

void choose_time_source(ViewerState& state, TimeSource source, double now);
void toggle_time_source(ViewerState& state, double now);
bool path_drives(const ViewerState& state);

/// Smooths the path by a Gaussian of a fiftieth of its duration.
void smooth_path(ViewerState& state, double now);
void remove_path(ViewerState& state, double now);

}  // namespace interleaf
