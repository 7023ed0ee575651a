// The frames of a film, or of a series of files: equally spaced times. Every frame is a function of its number
// alone, so frames can be made in any order and on any machine.
#pragma once

#include <cstddef>

#include "family/playback.h"

namespace interleaf {

struct FrameTimes {
    double begin = 0;       ///< time of frame 0
    double rate = 30;       ///< frames per second
    std::size_t count = 1;  ///< number of frames, at least 1

    /// The time of frame \p number.
    double at(std::size_t number) const { return begin + static_cast<double>(number) / rate; }
};

/// The largest number of frames, eleven hours at 25 frames per second.
inline constexpr std::size_t max_frame_count = 1'000'000;

/// The frames from the begin of \p range to its end: floor(duration * rate) + 1. A loop has one frame fewer
/// where its last frame would be its first again, at the end of the range.
/// \param rate  frames per second, above 0
/// \throw InputError if the range is not finite or ends before it begins, the rate is not a positive number, or
///                   there would be more than max_frame_count frames
FrameTimes frames_in(const TimeRange& range, double rate, bool is_loop = false);

}  // namespace interleaf
