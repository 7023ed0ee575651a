#include "ui/widgets/curve_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

CurvePlot::CurvePlot(const Rect& area, PlaceTime place_time, double least, double most)
    : area_(area), place_time_(std::move(place_time)), least_(least), most_(most) {
    ImGui::GetWindowDrawList()->AddRectFilled({area_.x, area_.y}, {area_.right(), area_.bottom()},
                                              colors::well, scaled(2));
}

void CurvePlot::draw(std::span<const double> times, std::span<const double> values, unsigned color) const {
    const float inset = scaled(3);
    std::vector<ImVec2> points;
    points.reserve(values.size());
    for (std::size_t n = 0; n < values.size(); ++n) {
        const double up = most_ > least_ ? (values[n] - least_) / (most_ - least_) : 0.5;
        points.push_back({place_time_(times[n]),
                          area_.bottom() - inset - (area_.height - 2 * inset) * static_cast<float>(up)});
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect({area_.x, area_.y}, {area_.right(), area_.bottom()}, true);
    list.AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, scaled(1.5F));
    list.PopClipRect();
}

void CurvePlot::mark(double time) const {
    const float x = place_time_(time);
    if (x < area_.x || x > area_.right()) return;
    ImGui::GetWindowDrawList()->AddLine({x, area_.y}, {x, area_.bottom()}, colors::dim_text);
}

std::size_t CurvePlot::nearest(std::span<const double> times, glm::vec2 pointer) const {
    const auto distance = [&](double time) { return std::abs(place_time_(time) - pointer.x); };
    return static_cast<std::size_t>(std::ranges::min_element(times, {}, distance) - times.begin());
}

}  // namespace interleaf
