#include "ui/widgets/scale_legend.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <imgui.h>

#include "text/value_text.h"
#include "ui/widgets/scale_ticks.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {

namespace {

/// Where \p value is along the bar, 0 to 1.
float part_at(const ColorScale& scale, double value) {
    const double min = scale.range.min;
    const double max = scale.range.max;
    if (scale.uses_logarithm()) return static_cast<float>(std::log(value / min) / std::log(max / min));
    return static_cast<float>((value - min) / (max - min));
}

/// The value at \p part of the bar, 0 to 1.
float value_at(const ColorScale& scale, float part) {
    const ValueRange& range = scale.range;
    if (scale.uses_logarithm()) return range.min * std::pow(range.max / range.min, part);
    return std::lerp(range.min, range.max, part);
}

/// Numbers with marks below the bar. A number that would touch an earlier number is left out.
class Numbers {
  public:
    Numbers(glm::vec2 corner, float width, const ColorScale& scale)
        : corner_(corner), width_(width), scale_(scale) {}

    /// \param value  with the offset of the scale
    void put(double value) {
        const double range = double{scale_.range.max} - double{scale_.range.min};
        const std::string text = value_text(value, range);
        const float x = width_ * part_at(scale_, value - scale_.offset);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled({corner_.x + std::floor(std::min(x, width_ - 1)), corner_.y},
                           {corner_.x + std::floor(std::min(x, width_ - 1)) + 1, corner_.y + scaled(4)},
                           colors::dim_text);
        const float text_width = text_size(text).x;
        const float left = std::clamp(x - text_width / 2, 0.0F, std::max(width_ - text_width, 0.0F));
        const auto touches = [&](const glm::vec2& span) {
            return left < span.y + scaled(8) && span.x < left + text_width + scaled(8);
        };
        if (std::ranges::any_of(spans_, touches)) return;
        spans_.emplace_back(left, left + text_width);
        draw_text({corner_.x + left, corner_.y + scaled(5)}, text_width + 1, colors::text, text);
    }

  private:
    glm::vec2 corner_;
    float width_;
    ColorScale scale_;
    std::vector<glm::vec2> spans_;
};

}  // namespace

void draw_scale_colors(glm::vec2 corner, glm::vec2 size, const ColorScale& scale) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto count = static_cast<int>(std::max(size.x, 1.0F));
    for (int n = 0; n < count; ++n) {
        const float part = (static_cast<float>(n) + 0.5F) / static_cast<float>(count);
        const float value = value_at(scale, part);
        const float x = corner.x + static_cast<float>(n);
        list.AddRectFilled({x, corner.y}, {x + 1, corner.y + size.y}, to_color(scale.color(value)));
    }
}

void scale_legend(const ColorScale& scale) {
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = scaled(12);
    draw_scale_colors(corner, {width, height}, scale);
    ImGui::PushFont(small_font());
    Numbers numbers({corner.x, corner.y + height}, width, scale);
    const double least = double{scale.range.min} + scale.offset;
    const double most = double{scale.range.max} + scale.offset;
    if (scale.range.max > scale.range.min) {
        numbers.put(least);
        numbers.put(most);
        const auto ticks = scale.uses_logarithm() ? logarithmic_ticks : scale_ticks;
        for (const double tick : ticks(least, most, 5)) numbers.put(tick);
    } else {
        draw_text({corner.x, corner.y + height + scaled(5)}, width, colors::text,
                  fmt::format("{} everywhere", value_text(least, 0)));
    }
    ImGui::Dummy({width, height + scaled(6) + ImGui::GetTextLineHeight()});
    ImGui::PopFont();
}

void edit_range(ColorScale& scale) {
    double ends[] = {double{scale.range.min} + scale.offset, double{scale.range.max} + scale.offset};
    ImGui::SetNextItemWidth(-1);
    const bool is_changed = ImGui::InputScalarN("##range", ImGuiDataType_Double, ends, 2, nullptr, nullptr,
                                                scale.offset == 0 ? "%.5g" : "%.9g");
    tooltip("Values of the first and the last color");
    if (!is_changed) return;
    const ValueRange range{static_cast<float>(ends[0] - scale.offset),
                           static_cast<float>(ends[1] - scale.offset)};
    if (std::isfinite(range.min) && std::isfinite(range.max) && range.min < range.max) scale.range = range;
}

}  // namespace interleaf
