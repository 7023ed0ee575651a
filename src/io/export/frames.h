// The frames of a family's time: the times at which its surface is written, and the weights at them.
#pragma once

#include <span>
#include <vector>

#include "family/family.h"
#include "io/export/export.h"

namespace interleaf {

struct Frame {
    double time = 0;
    Weights weights;
};

/// One frame per key of the timeline. Between two frames, linear interpolation of positions is the timeline's.
/// \pre the family has a timeline
std::vector<Frame> frames_of_keys(const Family& family);

/// Two frames per interval of the timeline, over the union of its two keys: a key that has the weight 0 is in the
/// weights. Where an interval ends, the next one begins at the next larger number.
/// \pre the family has a timeline
std::vector<Frame> frames_of_intervals(const Family& family);

/// \p per_second frames per unit of time, from the begin of the time on.
/// \throw UsageError unless \p per_second is positive and gives at most 100,000 frames
/// \pre   has_source(family, source)
std::vector<Frame> frames_per_second(const Family& family, TimeSource source, double per_second);

/// Frames at \p interval units of time, from the begin of the time to its end.
/// \throw UsageError unless \p interval is positive and gives at most 100,000 frames
/// \pre   has_source(family, source)
std::vector<Frame> frames_every(const Family& family, TimeSource source, double interval);

/// Frames at \p times.
/// \throw InputError if a time is outside the family's time, or there are more than 100,000
/// \pre   has_source(family, source)
std::vector<Frame> frames_at(const Family& family, TimeSource source, std::span<const double> times);

/// The keys in the weights of \p frames, ascending.
std::vector<std::size_t> keys_of(const std::vector<Frame>& frames);

}  // namespace interleaf
