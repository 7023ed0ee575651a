#include "family/frame_times.h"

#include <cmath>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {
namespace {

/// The products of a duration such as 0.1 and a rate such as 30 are rounded. A part of a frame below this is
/// rounding.
constexpr double rounding = 1e-6;

}  // namespace

FrameTimes frames_in(const TimeRange& range, double rate, bool is_loop) {
    if (!std::isfinite(range.begin) || !std::isfinite(range.end) || range.end < range.begin)
        throw InputError(
            fmt::format("the frames end at {}, before they begin at {}", range.end, range.begin));
    if (!(rate > 0) || !std::isfinite(rate))
        throw InputError(fmt::format("expected a number of frames per second above 0, got {}", rate));
    const double steps = (range.end - range.begin) * rate;
    if (!(steps < static_cast<double>(max_frame_count)))
        throw InputError(
            fmt::format("{:.0f} frames, at most {} can be made; a lower number of frames per "
                        "second makes fewer",
                        steps, max_frame_count));
    const double whole_steps = std::floor(steps + rounding);
    const bool ends_as_it_begins = is_loop && whole_steps >= 1 && steps - whole_steps < rounding;
    return {range.begin, rate, static_cast<std::size_t>(whole_steps) + (ends_as_it_begins ? 0 : 1)};
}

}  // namespace interleaf
