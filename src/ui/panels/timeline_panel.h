// The timeline: its keys as marks, the time to scrub, and the buttons of playback.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "family/family.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// A name that is held by the mouse, from press to release.
struct TimeDrag {
    std::size_t place;  ///< in the timeline
    double begin;       ///< of the timeline at the press, seconds: moving the first or the last key must not
    double end;         ///< move the time under the pointer
};

struct TimelineState {
    double time;  ///< seconds
    bool playing;
    bool loops;
    bool drives;                        ///< whether the surface follows the timeline
    std::string_view remark;            ///< why it does not
    std::optional<TimeDrag> drag = {};  ///< the last result's
};

/// A key at a time.
struct MovedTime {
    std::size_t place;  ///< in the timeline
    double to;          ///< seconds
};

struct KeyTime {
    std::size_t key;
    double time;  ///< seconds
};

struct TimelineResult {
    std::optional<double> seek_to;  ///< seconds
    bool toggle_playing = false;
    bool toggle_loop = false;
    std::optional<MovedTime> moved;         ///< dragged by its name
    std::optional<KeyTime> added;           ///< dropped on the track
    std::optional<std::size_t> asked_time;  ///< the place whose time is to be typed
    std::optional<std::size_t> removed;     ///< the place to take off the timeline
    std::optional<TimeDrag> drag;           ///< goes on: hand it to the next call
    Rect track;                             ///< from begin to end
};

/// \pre  the family has a timeline
TimelineResult timeline_panel(const Rect& rect, const Family& family, const TimelineState& state);

}  // namespace interleaf
