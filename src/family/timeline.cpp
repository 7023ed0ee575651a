#include "family/timeline.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {

Timeline::Timeline(std::vector<TimelineKey> keys) : keys_(std::move(keys)) {
    if (keys_.empty()) throw InputError("the timeline has no key; it needs at least one");
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        if (!std::isfinite(keys_[i].time)) {
            throw InputError(fmt::format("the time of timeline key {} is not a finite number", i));
        }
        if (i > 0 && keys_[i].time <= keys_[i - 1].time) {
            throw InputError(fmt::format(
                "timeline key {} is at time {}, but times must ascend and the key before it is at {}", i,
                keys_[i].time, keys_[i - 1].time));
        }
    }
    if (!std::isfinite(end() - begin())) {
        throw InputError(
            fmt::format("the times of the timeline, {:.10g} to {:.10g}, are too far apart", begin(), end()));
    }
}

Weights Timeline::at(double time) const {
    if (std::isnan(time)) throw InputError("the time is not a number");
    if (keys_.size() == 1) return {{keys_.front().key, 1}};

    time = std::clamp(time, begin(), end());
    // The end belongs to the last interval, so the search excludes it.
    const auto after = std::upper_bound(keys_.begin() + 1, keys_.end() - 1, time,
                                        [](double t, const TimelineKey& key) { return t < key.time; });
    const TimelineKey& from = *(after - 1);
    const TimelineKey& to = *after;
    if (from.key == to.key) return {{from.key, 1}};
    const double s = (time - from.time) / (to.time - from.time);
    return sorted_weights({{from.key, 1 - s}, {to.key, s}});
}

}  // namespace interleaf
