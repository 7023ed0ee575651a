// The scale of the timeline: which times are visible, and where. Times are in the unit of the timeline or the path.
#pragma once

#include <string>
#include <vector>

#include "family/playback.h"
#include "family/timeline.h"
#include "ui/widgets/rect.h"

namespace interleaf {

struct TimeScale {
    TimeRange visible;  ///< from the left to the right end of the track
    Rect track;         ///< screen coordinates

    float pixel(double time) const;

    /// The time at the horizontal position \p pixel, also beside the track.
    double time(float pixel) const;

    /// The power of ten below a hundredth of the visible times, as an exponent: dragged times are multiples
    /// of it.
    int readable_exponent() const;

    /// The time at \p pixel, rounded to readable_exponent().
    double readable_time(float pixel) const;
};

/// \p visible, made shorter or longer by \p factor about \p fixed, which keeps its place. Stays within \p
/// whole, and is not shorter than a millionth of it.
TimeRange zoomed(TimeRange visible, TimeRange whole, double fixed, double factor);

/// \p visible, moved by \p distance as far as \p whole permits.
TimeRange panned(TimeRange visible, TimeRange whole, double distance);

struct TimeTick {
    double time;
    std::string label;  ///< empty for a tick between two labels
};

/// The ticks of the ruler: round times with labels at least \p label_distance pixels apart, and ticks between
/// them. Steps have whole numbers, as long as more than one step is visible.
std::vector<TimeTick> time_ticks(const TimeScale& scale, float label_distance,
                                 TimeUnit unit = TimeUnit::seconds);

}  // namespace interleaf
