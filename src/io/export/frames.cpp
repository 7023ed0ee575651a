#include "io/export/frames.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

#include <fmt/core.h>

#include "family/family_time.h"
#include "family/frame_times.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

constexpr std::size_t max_files = 100'000;

/// \throw UsageError naming the option
FrameTimes frame_times(const TimeRange& range, double per_second) {
    try {
        return frames_in(range, per_second);
    } catch (const InputError& error) {
        throw UsageError(fmt::format("--fps: {}", error.what()));
    }
}

}  // namespace

std::vector<Frame> frames_of_keys(const Family& family) {
    std::vector<Frame> frames;
    for (const TimelineKey& key : family.timeline->keys()) frames.push_back({key.time, {{key.key, 1.0}}});
    return frames;
}

std::vector<Frame> frames_of_intervals(const Family& family) {
    const auto keys = family.timeline->keys();
    if (keys.size() == 1) return frames_of_keys(family);
    std::vector<Frame> frames;
    for (std::size_t n = 0; n + 1 < keys.size(); ++n) {
        const TimelineKey& from = keys[n];
        const TimelineKey& to = keys[n + 1];
        const double begin = n == 0 ? from.time : std::nextafter(from.time, HUGE_VAL);
        frames.push_back({begin, sorted_weights({{from.key, 1.0}, {to.key, 0.0}})});
        frames.push_back({to.time, sorted_weights({{from.key, 0.0}, {to.key, 1.0}})});
    }
    return frames;
}

std::vector<Frame> frames_per_second(const Family& family, TimeSource source, double per_second) {
    const TimeRange range = interval_of(family, source);
    const FrameTimes times = frame_times(range, per_second);
    if (times.count > max_files)
        throw UsageError(
            fmt::format("--fps: {} gives {} files, expected at most {}", per_second, times.count, max_files));
    std::vector<Frame> frames;
    frames.reserve(times.count);
    for (std::size_t n = 0; n < times.count; ++n) {
        const double time = std::min(times.at(n), range.end);
        frames.push_back({time, weights_at(family, time, source)});
    }
    return frames;
}

std::vector<Frame> frames_every(const Family& family, TimeSource source, double interval) {
    constexpr double rounding = 1e-9;  // of the number of intervals, so that the end of the time is a frame
    const TimeRange range = interval_of(family, source);
    const double count = (range.end - range.begin) / interval * (1 + rounding) + 1;
    if (!(interval > 0 && count <= static_cast<double>(max_files)))
        throw UsageError(
            fmt::format("--every: {} gives no number of files from 1 to {}, expected a larger step", interval,
                        max_files));
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(count));
    for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n)
        times.push_back(std::min(range.begin + static_cast<double>(n) * interval, range.end));
    return frames_at(family, source, times);
}

std::vector<Frame> frames_at(const Family& family, TimeSource source, std::span<const double> times) {
    if (times.size() > max_files)
        throw InputError(fmt::format("{} times, expected at most {}", times.size(), max_files));
    const TimeRange range = interval_of(family, source);
    std::vector<Frame> frames;
    frames.reserve(times.size());
    for (const double time : times) {
        if (!(time >= range.begin && time <= range.end))
            throw InputError(fmt::format("time {} is outside the time of the family, {} to {}", time,
                                         range.begin, range.end));
        frames.push_back({time, weights_at(family, time, source)});
    }
    return frames;
}

std::vector<std::size_t> keys_of(const std::vector<Frame>& frames) {
    std::set<std::size_t> keys;
    for (const Frame& frame : frames)
        for (const Weight& weight : frame.weights) keys.insert(weight.key);
    return {keys.begin(), keys.end()};
}

}  // namespace interleaf
