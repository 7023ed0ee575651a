#include "family/timeline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

/// Inserts \p added behind the entries that are not later.
void insert(std::vector<TimelineKey>& keys, const TimelineKey& added) {
    keys.insert(std::ranges::upper_bound(keys, added.time, {}, &TimelineKey::time), added);
}

}  // namespace

std::string_view name_of(TimeUnit unit) {
    return unit == TimeUnit::steps ? "steps" : "seconds";
}

std::optional<TimeUnit> time_unit_named(std::string_view name) {
    for (const TimeUnit unit : {TimeUnit::seconds, TimeUnit::steps})
        if (name == name_of(unit)) return unit;
    return std::nullopt;
}

std::string time_text(double time, std::string_view unit) {
    return unit.empty() ? fmt::format("step {:.10g}", time) : fmt::format("{:.10g} {}", time, unit);
}

Timeline::Timeline(std::vector<TimelineKey> keys, Interpolation interpolation, TimeUnit unit)
    : keys_(std::move(keys)), interpolation_(interpolation), unit_(unit) {
    check();
}

void Timeline::check() const {
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
    return weights_at(interpolation_, keys_, std::clamp(time, begin(), end()));
}

std::optional<std::size_t> Timeline::place_at(double time) const {
    const auto found = std::ranges::find(keys_, time, &TimelineKey::time);
    if (found == keys_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - keys_.begin());
}

Timeline Timeline::with_entries(std::vector<TimelineKey> keys) const {
    Timeline edited = *this;
    edited.keys_ = std::move(keys);
    edited.check();
    return edited;
}

Timeline Timeline::with_entry(TimelineKey added) const {
    std::vector<TimelineKey> keys = keys_;
    insert(keys, added);
    return with_entries(std::move(keys));
}

Timeline Timeline::with_time(std::size_t place, double time) const {
    std::vector<TimelineKey> keys = keys_;
    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(place));
    insert(keys, {time, keys_[place].key});
    return with_entries(std::move(keys));
}

std::optional<Timeline> Timeline::without_entry(std::size_t place) const {
    if (keys_.size() == 1) return std::nullopt;
    std::vector<TimelineKey> keys = keys_;
    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(place));
    return with_entries(std::move(keys));
}

std::optional<Timeline> Timeline::without_key(std::size_t key) const {
    std::vector<TimelineKey> keys = keys_;
    std::erase_if(keys, [&](const TimelineKey& entry) { return entry.key == key; });
    if (keys.empty()) return std::nullopt;
    return with_entries(std::move(keys));
}

Timeline Timeline::with_interpolation(Interpolation interpolation) const {
    Timeline edited = *this;
    edited.interpolation_ = interpolation;
    return edited;
}

Timeline Timeline::with_unit(TimeUnit unit) const {
    Timeline edited = *this;
    edited.unit_ = unit;
    return edited;
}

Timeline Timeline::with_keys_renumbered(const std::function<std::size_t(std::size_t)>& new_index) const {
    std::vector<TimelineKey> keys = keys_;
    for (TimelineKey& entry : keys) entry.key = new_index(entry.key);
    return with_entries(std::move(keys));
}

}  // namespace interleaf
