#include "ui/timeline/blend_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/curve_plot.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// A figure of the blend: its name, and its value in words.
struct BlendFigure {
    const char* name;
    double BlendSample::*value;
    std::string (*in_words)(double value);
};

std::string as_number(double value) {
    return fmt::format("{:.4g}", value);
}

std::string as_count(double value) {
    return grouped(static_cast<std::size_t>(std::lround(value)));
}

constexpr std::array<BlendFigure, 3> blend_figures = {{{"Area", &BlendSample::area, as_number},
                                                       {"Volume", &BlendSample::volume, as_number},
                                                       {"Leaves", &BlendSample::leaves, as_count}}};

/// Draws the name and the present value over the left end of a plot.
void label_plot(const Rect& area, const std::string& text) {
    const float height = ImGui::GetTextLineHeight();
    const float width = std::min(text_size(text).x, area.width - scaled(8));
    const glm::vec2 corner(area.x + scaled(4), area.y + std::round((area.height - height) / 2));
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x - scaled(2), corner.y},
                                              {corner.x + width + scaled(2), corner.y + height},
                                              colors::label, scaled(2));
    draw_text(corner, width + 1, colors::text, text);
}

}  // namespace

void blend_plots(const Rect& area, const TimeScale& scale, const BlendCurves& curves, double time) {
    ImGui::PushFont(small_font());
    std::vector<double> times;
    times.reserve(curves.size());
    for (const BlendSample& sample : curves) times.push_back(sample.time);
    const float gap = scaled(2);
    const float height = (area.height - 2 * gap) / static_cast<float>(blend_figures.size());
    float top = area.y;
    for (const BlendFigure& figure : blend_figures) {
        const Rect place{area.x, top, area.width, height};
        top += height + gap;
        std::vector<double> values;
        values.reserve(curves.size());
        for (const BlendSample& sample : curves) values.push_back(sample.*figure.value);
        const auto [least, most] =
            values.empty() ? std::ranges::minmax_result<double>{0, 0} : std::ranges::minmax(values);
        const CurvePlot plot(
            place, [&](double at) { return scale.pixel(at); }, least, most);
        plot.draw(times, values, colors::accent);
        plot.mark(time);
        std::string text = figure.name;
        if (!times.empty()) {
            const std::size_t here = plot.nearest(times, {scale.pixel(time), 0});
            text += "  " + figure.in_words(values[here]);
            if (most > least)
                text += fmt::format("   ({} to {})", figure.in_words(least), figure.in_words(most));
        }
        label_plot(place, text);
        ImGui::SetCursorScreenPos({place.x, place.y});
        ImGui::PushID(figure.name);
        mouse_area("plot", {std::max(place.width, 1.0F), std::max(place.height, 1.0F)});
        ImGui::PopID();
        if (!ImGui::IsItemHovered() || times.empty()) continue;
        const std::size_t at = plot.nearest(times, from_imgui(ImGui::GetIO().MousePos));
        ImGui::SetTooltip("%s of the blend at time %.4g: %s", figure.name, times[at],
                          figure.in_words(values[at]).c_str());
    }
    ImGui::PopFont();
}

}  // namespace interleaf
