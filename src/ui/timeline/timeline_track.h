// The ruler of the timeline, the track with its keys as marks, and their names. Times are in the unit of the timeline
// or the path.
#pragma once

#include <cstddef>
#include <optional>

#include "family/family.h"
#include "family/playback.h"
#include "ui/timeline/time_scale.h"

namespace interleaf {

/// A key of the timeline, or a point of the path, that is held by the mouse, from press to release.
struct TimeDrag {
    std::size_t place;  ///< in the timeline or the path
    TimeRange visible;  ///< at the press: moving the first or the last key must not move the time under the
                        ///< pointer
};

/// A key or a point at a time.
struct MovedTime {
    std::size_t place;  ///< in the timeline or the path
    double to;
};

struct KeyTime {
    std::size_t key;
    double time;
};

/// A point that the user sets by the menu of the ruler.
struct RangeEdit {
    std::optional<double> in{};
    std::optional<double> out{};
    bool clears = false;  ///< plays the whole timeline again
};

struct TrackResult {
    std::optional<double> seek_to;
    std::optional<MovedTime> moved;         ///< dragged by its mark or name
    std::optional<KeyTime> added;           ///< dropped on the track
    std::optional<std::size_t> asked_time;  ///< the place whose time is to be typed
    std::optional<std::size_t> removed;     ///< the place to take off the timeline, or out of the path
    std::optional<TimeDrag> drag;           ///< goes on: hand it to the next call
    std::optional<RangeEdit> range;
    std::optional<TimeRange> visible;  ///< the times to show from now on
};

/// The parts of the track from top to bottom; all have the width of the track.
struct TrackLayout {
    Rect ruler;
    Rect track;
    Rect names;
};

struct TrackState {
    double time;                     ///< the present one
    bool drives;                     ///< whether the surface follows the timeline
    std::optional<TimeRange> range;  ///< the in and out points
    std::optional<TimeDrag> drag;    ///< the last result's
    TimeSource source;               ///< keys, or the path, whose points are marks without names
};

/// Shows the track of \p family, and lets the user scrub, zoom with the wheel, and move keys.
/// \param whole  the times that can be shown
/// \pre has_source(family, state.source)
TrackResult show_track(const TrackLayout& layout, const Family& family, const TimeScale& scale,
                       TimeRange whole, const TrackState& state);

/// The times to show after the user has turned the wheel over the last item, or dragged it with the middle
/// button; none for no change.
std::optional<TimeRange> moved_view(const TimeScale& scale, TimeRange whole);

}  // namespace interleaf
