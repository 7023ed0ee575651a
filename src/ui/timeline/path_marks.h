// The points of a path as marks below the track: dragging one moves its point in time, the right mouse button
// has a menu.
#pragma once

#include "family/domain_path.h"
#include "ui/timeline/timeline_track.h"

namespace interleaf {

/// Marks that would overlap are left out, unless the mouse holds them.
void show_path_marks(const TrackLayout& layout, const DomainPath& path, const TimeScale& scale,
                     const TrackState& state, TrackResult& result);

}  // namespace interleaf
