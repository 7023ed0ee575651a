// The timeline: its keys as marks, the time to scrub, and the buttons of playback.
#pragma once

#include <optional>

#include "family/family.h"
#include "ui/rect.h"

namespace interleaf {

struct TimelineState {
    double time;  ///< seconds
    bool playing;
    bool loops;
    bool drives;  ///< the morph; otherwise the point has left the timeline's path
};

struct TimelineResult {
    std::optional<double> seek_to;  ///< seconds
    bool toggle_playing = false;
    bool toggle_loop = false;
    Rect track;  ///< from begin to end
};

/// \pre  the family has a timeline
TimelineResult timeline_panel(const Rect& rect, const Family& family, const TimelineState& state);

}  // namespace interleaf
