#include "ui/timeline/weight_curves.h"

#include <algorithm>
#include <map>
#include <utility>

#include <imgui.h>

#include "family/family_time.h"
#include "render/palette.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// The times of samples, ascending: equidistant, and those of the visible marks.
std::vector<double> sample_times(const std::vector<double>& marks, TimeRange visible, std::size_t count) {
    std::vector<double> times;
    times.reserve(count + 1 + marks.size());
    for (std::size_t i = 0; i <= count; ++i)
        times.push_back(visible.begin +
                        (visible.end - visible.begin) * static_cast<double>(i) / static_cast<double>(count));
    const auto first = std::ranges::lower_bound(marks, visible.begin);
    const auto last = std::ranges::upper_bound(marks, visible.end);
    // Where there are many marks, the samples are dense enough without them.
    const bool are_few = last - first <= 4 * static_cast<std::ptrdiff_t>(count);
    if (first < last && are_few) times.insert(times.end(), first, last);
    std::ranges::sort(times);
    times.erase(std::ranges::unique(times).begin(), times.end());
    return times;
}

/// The least and the largest weight, with 0 and 1.
struct WeightRange {
    double min = 0;
    double max = 1;
};

WeightRange range_of(std::span<const WeightCurve> curves) {
    WeightRange range;
    for (const WeightCurve& curve : curves)
        for (const WeightCurve::Point& point : curve.points) {
            range.min = std::min(range.min, point.weight);
            range.max = std::max(range.max, point.weight);
        }
    return range;
}

}  // namespace

std::vector<WeightCurve> weight_curves(const Family& family, TimeSource source, TimeRange visible,
                                       std::size_t sample_count) {
    std::vector<WeightCurve> curves;
    std::map<std::size_t, std::size_t> open;  // the curve of each key that was active at the last sample
    const bool jumps = source == TimeSource::keys && family.timeline->interpolation().basis == Basis::hold;
    const std::vector<double> marks = marked_times(family, source);
    for (const double time : sample_times(marks, visible, std::max<std::size_t>(sample_count, 1))) {
        std::map<std::size_t, std::size_t> still_open;
        for (const auto& [key, value] : weights_at(family, time, source)) {
            const auto found = open.find(key);
            const std::size_t curve = found == open.end() ? curves.size() : found->second;
            if (found == open.end()) curves.push_back({key, {}});
            curves[curve].points.push_back({time, value});
            still_open[key] = curve;
        }
        // A key that becomes inactive at its neighbor's time falls to 0 there.
        for (const auto& [key, curve] : open)
            if (!still_open.contains(key)) {
                const double last = jumps ? curves[curve].points.back().weight : 0;
                curves[curve].points.push_back({time, last});
            }
        open = std::move(still_open);
    }
    return curves;
}

void draw_weight_curves(const Rect& area, const TimeScale& scale, std::span<const WeightCurve> curves,
                        double time, const Weights& weights) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    WeightRange range = range_of(curves);
    for (const Weight& weight : weights) {
        range.min = std::min(range.min, weight.value);
        range.max = std::max(range.max, weight.value);
    }
    const float margin = scaled(4);
    const auto height_of = [&](double weight) {
        const auto part = static_cast<float>((weight - range.min) / (range.max - range.min));
        return area.bottom() - margin - part * (area.height - 2 * margin);
    };
    list.AddRectFilled({area.x, area.y}, {area.right(), area.bottom()}, colors::well, scaled(3));
    for (const double line : {0.0, 1.0})
        list.AddLine({area.x, height_of(line)}, {area.right(), height_of(line)}, colors::faint_line);

    list.PushClipRect({area.x - margin, area.y}, {area.right() + margin, area.bottom()}, true);
    std::vector<ImVec2> points;
    for (const WeightCurve& curve : curves) {
        points.clear();
        for (const WeightCurve::Point& point : curve.points)
            points.push_back({scale.pixel(point.time), height_of(point.weight)});
        list.AddPolyline(points.data(), static_cast<int>(points.size()), to_color(key_color(curve.key)),
                         ImDrawFlags_None, scaled(1.5F));
    }
    const float x = scale.pixel(time);
    list.AddLine({x, area.y}, {x, area.bottom()}, weights.empty() ? colors::faint_line : colors::dim_text);
    for (const Weight& weight : weights) {
        const ImVec2 at{x, height_of(weight.value)};
        list.AddCircleFilled(at, scaled(4), colors::rim);
        list.AddCircleFilled(at, scaled(3), to_color(key_color(weight.key)));
    }
    list.PopClipRect();
}

}  // namespace interleaf
