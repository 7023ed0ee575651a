#include "io/export/frames.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/core.h>

#include "family/family_time.h"
#include "hierarchy/error.h"

namespace interleaf {

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
    constexpr double max_frames = 100'000;
    const TimeRange range = interval_of(family, source);
    const double count = std::floor((range.end - range.begin) * per_second + 1e-6) + 1;
    if (!(per_second > 0) || !(count <= max_frames))
        throw UsageError(fmt::format("--fps: {} gives {} frames, expected at most {}", per_second, count,
                                     static_cast<int>(max_frames)));
    std::vector<Frame> frames;
    for (double n = 0; n < count; ++n) {
        const double time = std::min(range.begin + n / per_second, range.end);
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
