#include "ui/timeline/time_scale.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "ui/widgets/number_text.h"
#include "ui/widgets/scale_ticks.h"

namespace interleaf {

namespace {

double length(TimeRange range) {
    return range.end - range.begin;
}

}  // namespace

float TimeScale::pixel(double time) const {
    const double part = length(visible) > 0 ? (time - visible.begin) / length(visible) : 0;
    // Times far outside the visible ones have no meaningful place, but must not overflow.
    return track.x + track.width * static_cast<float>(std::clamp(part, -1e4, 1e4));
}

double TimeScale::time(float pixel) const {
    return visible.begin + length(visible) * static_cast<double>((pixel - track.x) / track.width);
}

int TimeScale::readable_exponent() const {
    const double span = length(visible) > 0 ? length(visible) : 1;
    return static_cast<int>(std::floor(std::log10(span / 100)));
}

double TimeScale::readable_time(float pixel) const {
    const TimeScale scale{length(visible) > 0 ? visible : TimeRange{visible.begin, visible.begin + 1}, track};
    return rounded_to_power(scale.time(pixel), readable_exponent());
}

TimeRange panned(TimeRange visible, TimeRange whole, double distance) {
    const double begin =
        std::clamp(visible.begin + distance, whole.begin, std::max(whole.end - length(visible), whole.begin));
    return {begin, std::min(begin + length(visible), whole.end)};
}

TimeRange zoomed(TimeRange visible, TimeRange whole, double fixed, double factor) {
    const double shortest = length(whole) * 1e-6;
    const double wanted = std::clamp(length(visible) * factor, shortest, length(whole));
    if (wanted >= length(whole)) return whole;
    const double part =
        length(visible) > 0 ? std::clamp((fixed - visible.begin) / length(visible), 0.0, 1.0) : 0.5;
    const double begin = fixed - part * wanted;
    return panned({begin, begin + wanted}, whole, 0);
}

std::vector<TimeTick> time_ticks(const TimeScale& scale, float label_distance, TimeUnit unit) {
    const auto [begin, end] = scale.visible;
    const auto max_labels = static_cast<std::size_t>(std::max(scale.track.width / label_distance, 2.0F));
    std::vector<double> labelled = scale_ticks(begin, end, max_labels);
    std::vector<double> all = scale_ticks(begin, end, 5 * max_labels);
    if (unit == TimeUnit::steps && end - begin > 1)
        for (std::vector<double>* const times : {&labelled, &all})
            std::erase_if(*times, [](double time) { return std::abs(time - std::round(time)) > 1e-9; });
    std::vector<TimeTick> ticks;
    for (const double time : all)
        if (std::ranges::find_if(labelled, [&](double other) {
                return std::abs(other - time) < (end - begin) * 1e-9;
            }) == labelled.end())
            ticks.push_back({time, ""});
    for (const double time : labelled) ticks.push_back({time, fmt::format("{:.10g}", time)});
    return ticks;
}

}  // namespace interleaf
