#include "ui/panels/field_curves.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include <fmt/core.h>
#include <glm/vec2.hpp>
#include <imgui.h>

#include "text/value_text.h"
#include "ui/widgets/curve_plot.h"
#include "ui/widgets/rect.h"
#include "ui/widgets/style.h"

namespace interleaf {
namespace {

/// A plot as wide as the current panel, over the times of the curves.
class PanelPlot {
  public:
    /// \param times  at least two
    PanelPlot(const std::vector<double>& times, double least, double most)
        : times_(times),
          area_(next_area()),
          plot_(
              area_, [this](double at) { return pixel(at); }, least, most) {}
    PanelPlot(const PanelPlot&) = delete;  // the plot refers to this object
    PanelPlot& operator=(const PanelPlot&) = delete;
    ~PanelPlot() = default;

    void draw(const std::vector<double>& values, unsigned color) const { plot_.draw(times_, values, color); }

    /// Ends the plot with a line at \p time. The pointer reads the figures at the nearest key.
    /// \return that key while the pointer is over the plot; else no key
    std::size_t end(double time) const {
        plot_.mark(time);
        ImGui::Dummy({area_.width, area_.height});
        return ImGui::IsItemHovered() ? plot_.nearest(times_, from_imgui(ImGui::GetIO().MousePos))
                                      : times_.size();
    }

  private:
    static Rect next_area() {
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        return {corner.x, corner.y, ImGui::GetContentRegionAvail().x, scaled(48)};
    }

    float pixel(double time) const {
        const float inset = scaled(3);
        const double across = (time - times_.front()) / (times_.back() - times_.front());
        return area_.x + inset + (area_.width - 2 * inset) * static_cast<float>(across);
    }

    const std::vector<double>& times_;
    Rect area_;
    CurvePlot plot_;
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
    const PanelPlot integral(curves.times, low, high);
    integral.draw(curves.integrals, colors::accent);
    if (const std::size_t key = integral.end(time); key < curves.times.size())
        ImGui::SetTooltip("%s%.6g", time_prefix(curves, key).c_str(), curves.integrals[key]);

    const double least = std::ranges::min(curves.least);
    const double most = std::ranges::max(curves.most);
    heading("Least and largest", values_text(least, most, curves.unit));
    const PanelPlot ends(curves.times, least, most);
    ends.draw(curves.least, colors::dim_text);
    ends.draw(curves.most, colors::accent);
    if (const std::size_t key = ends.end(time); key < curves.times.size())
        ImGui::SetTooltip("%s%s", time_prefix(curves, key).c_str(),
                          values_text(curves.least[key], curves.most[key], curves.unit).c_str());
}

}  // namespace interleaf
