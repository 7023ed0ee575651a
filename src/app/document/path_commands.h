// The commands on the path through the parameter domain: recording, smoothing, removing, editing its points,
// and the choice of whether keys or the path drive; and typing places in the domain. Each change of the family
// is an undoable step of the document.
#pragma once

#include <cstddef>
#include <optional>

#include "app/document/viewer_state.h"

namespace interleaf {

/// Begins to record a path, or ends it: the dragged points, with few points where few suffice, become the path
/// of the family, which then drives. Without two points the family stays as it is.
void toggle_recording(ViewerState& state, double now);

/// Adds the present point of the session to the recording, if one goes on.
void record_point(ViewerState& state, double now);

/// Lets \p source drive, as an edit. Does nothing if \p source already drives.
void choose_time_source(ViewerState& state, TimeSource source, double now);

/// Lets \p source drive as long as the window is open or until the user chooses. That is no edit: the document is
/// not changed, and is saved with its own choice (Document::drive_in_this_run()).
/// \pre has_source()
void drive_in_this_run(ViewerState& state, TimeSource source, double now);

void toggle_time_source(ViewerState& state, double now);
bool path_drives(const ViewerState& state);

/// Smooths the path by a Gaussian of a fiftieth of its duration.
void smooth_path(ViewerState& state, double now);
void remove_path(ViewerState& state, double now);

/// One movement of a drag of a path point (drag_edit()). The time follows to the point, so that the surface
/// shows the blend there.
void move_path_point(ViewerState& state, std::size_t place, const PathPoint& to, double now);

/// Begins a drag with another point of the path.
/// \return whether the path could take the point
bool insert_path_point(ViewerState& state, const PathPoint& added, double now);

void select_path_point(ViewerState& state, std::size_t place, double now);
void remove_path_point(ViewerState& state, std::size_t place, double now);

/// These functions ask the user for numbers first.
void ask_for_path_point_time(ViewerState& state, std::size_t place);
void ask_for_path_point_place(ViewerState& state, std::size_t place);

/// Asks for the place of the point of the blend.
void ask_for_place(ViewerState& state);

/// Asks for the place of \p vertex of the domain. A place where a triangle would turn over is refused.
void ask_for_vertex_place(ViewerState& state, Index vertex);

/// The first vertex of the domain that has the selected key; none without one.
std::optional<Index> vertex_of_selected_key(const ViewerState& state);

/// Asks for the place of the selected key in the domain: that of its vertex, or of a new one.
void ask_for_key_place(ViewerState& state);

/// Goes to the next key or point of the path (\p direction 1) or to the previous one (-1), as
/// Session::seek_key(). While the domain is edited, this selects the point.
void go_to_key(ViewerState& state, int direction, double now);

}  // namespace interleaf
