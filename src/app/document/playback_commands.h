// The commands of the Playback menu that need more than the session: questions, the in and out points, and
// the interpolation of the timeline. Without a timeline or a path they do nothing.
#pragma once

#include <cstddef>

#include "app/document/viewer_state.h"
#include "family/interpolation.h"

namespace interleaf {

/// These functions ask the user for a number first.
void ask_for_present_time(ViewerState& state);
void ask_for_speed(ViewerState& state);
void ask_for_frame_rate(ViewerState& state);
void ask_for_degree(ViewerState& state);

/// Doubles the speed (\p direction 1) or halves it (-1).
void change_speed(ViewerState& state, int direction, double now);

/// Goes on to the next way to repeat.
void cycle_repeat(ViewerState& state, double now);

/// Sets the in or the out point. A point beyond the other one takes that one along to the end of the interval.
/// \param time  in the unit of the timeline or the path
void set_in_point(ViewerState& state, double time, double now);
void set_out_point(ViewerState& state, double time, double now);

/// An undoable step of the document.
void choose_interpolation(ViewerState& state, Interpolation interpolation, double now);

/// Goes on to the next basis, with its default degree.
void cycle_interpolation(ViewerState& state, double now);

/// Puts the selected key on the timeline at the present time.
void add_present_time(ViewerState& state, double now);

/// Takes the key at the present time off the timeline.
void remove_present_time(ViewerState& state, double now);

/// Whether a key of the timeline is at the present time.
bool has_present_time(const ViewerState& state);

}  // namespace interleaf
