#include "ui/panels/field_curves.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

#include "text/value_text.h"
#include <fmt/core.h>
#include <glm/vec2.hpp>
#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {
namespace {

/// A plot of curves that share one scale.
class CurvePlot {
  public:
    /// \param times  at least two
    CurvePlot(std::span<const double> times, double least, double most)
        : times_(times),
          least_(least),
          most_(most),
          corner_(from_imgui(ImGui::GetCursorScreenPos())),
          size_(ImGui::GetContentRegionAvail().x, scaled(48)) {
        ImGui::GetWindowDrawList()->AddRectFilled(to_imgui(corner_), to_imgui(corner_ + size_), colors::well,
                                                  scaled(2));
    }

    void draw(std::span<const double> values, unsigned color) const {
        std::vector<ImVec2> points;
        points.reserve(values.size());
        for (std::size_t n = 0; n < values.size(); ++n)
            points.push_back(to_imgui(place(times_[n], values[n])));
        ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), color, 0,
                                                scaled(1.5F));
    }

    /// Ends the plot with a line at \p time. The pointer reads the figures at the nearest key.
    /// \return that key while the pointer is over the plot; else no key
    std::size_t end(double time) const {
        if (time >= times_.front() && time <= times_.back()) {
            const float x = place(time, least_).x;
            ImGui::GetWindowDrawList()->AddLine({x, corner_.y}, {x, corner_.y + size_.y}, colors::dim_text);
        }
        ImGui::Dummy(to_imgui(size_));
        if (!ImGui::IsItemHovered()) return times_.size();
        const auto distance = [&](double each) {
            const float away = place(each, least_).x - ImGui::GetIO().MousePos.x;
            return away < 0 ? -away : away;
        };
        return static_cast<std::size_t>(std::ranges::min_element(times_, {}, distance) - times_.begin());
    }

  private:
    glm::vec2 place(double time, double value) const {
        const float inset = scaled(3);
        const double across = (time - times_.front()) / (times_.back() - times_.front());
        const double up = most_ > least_ ? (value - least_) / (most_ - least_) : 0.5;
        return {corner_.x + inset + (size_.x - 2 * inset) * static_cast<float>(across),
                corner_.y + size_.y - inset - (size_.y - 2 * inset) * static_cast<float>(up)};
    }

    std::span<const double> times_;
    double least_;
    double most_;
    glm::vec2 corner_;
    glm::vec2 size_;
};

std::string values_text(double least, double most, const std::string& unit) {
    const double range = most - least;
    return with_unit(most > least ? fmt::format("{} to {}", value_text(least, range), value_text(most, range))
                                  : value_text(least, 0),
                     unit);
}

/// "step 3: " or "0.5 ms: ".
std::string time_prefix(const FieldCurves& curves, std::size_t key) {
    return curves.time_unit.empty() ? fmt::format("step {:.4g}: ", curves.times[key])
                                    : fmt::format("{:.4g} {}: ", curves.times[key], curves.time_unit);
}

}  // namespace

void field_curves(const FieldCurves& curves, double time) {
    if (curves.times.size() < 2) return;
    const auto [low, high] = std::ranges::minmax(curves.integrals);
    heading("Integral", values_text(low, high, {}));
    const CurvePlot integral(curves.times, low, high);
    integral.draw(curves.integrals, colors::accent);
    if (const std::size_t key = integral.end(time); key < curves.times.size())
        ImGui::SetTooltip("%s%.6g", time_prefix(curves, key).c_str(), curves.integrals[key]);

    const double least = std::ranges::min(curves.least);
    const double most = std::ranges::max(curves.most);
    heading("Least and largest", values_text(least, most, curves.unit));
    const CurvePlot ends(curves.times, least, most);
    ends.draw(curves.least, colors::dim_text);
    ends.draw(curves.most, colors::accent);
    if (const std::size_t key = ends.end(time); key < curves.times.size())
        ImGui::SetTooltip("%s%s", time_prefix(curves, key).c_str(),
                          values_text(curves.least[key], curves.most[key], curves.unit).c_str());
}

}  // namespace interleaf
