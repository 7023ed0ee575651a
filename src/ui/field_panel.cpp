#include "ui/field_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/core.h>
#include <imgui.h>

#include "ui/scale_ticks.h"
#include "ui/style.h"

namespace interleaf {

namespace {

/// The colours of \p scale from \p corner on, over \p range.
void draw_colors(glm::vec2 corner, glm::vec2 size, const ColorScale& scale) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto count = static_cast<int>(std::max(size.x, 1.0F));
    for (int n = 0; n < count; ++n) {
        const float part = (static_cast<float>(n) + 0.5F) / static_cast<float>(count);
        const float value = std::lerp(scale.range.min, scale.range.max, part);
        const float x = corner.x + static_cast<float>(n);
        list.AddRectFilled({x, corner.y}, {x + 1, corner.y + size.y}, to_color(scale.color(value)));
    }
}

/// Numbers below the bar, with marks; those that would touch a number that is there already are left out.
class Numbers {
  public:
    Numbers(glm::vec2 corner, float width, const ValueRange& range)
        : corner_(corner), width_(width), range_(range) {}

    void put(double value, const std::string& text) {
        const double length = static_cast<double>(range_.max) - range_.min;
        const float x = width_ * static_cast<float>((value - range_.min) / length);
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
    ValueRange range_;
    std::vector<glm::vec2> spans_;
};

void scale_legend(const ColorScale& scale) {
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = scaled(12);
    draw_colors(corner, {width, height}, scale);
    ImGui::PushFont(small_font());
    Numbers numbers({corner.x, corner.y + height}, width, scale.range);
    if (scale.range.max > scale.range.min) {
        numbers.put(scale.range.min, fmt::format("{:.4g}", scale.range.min));
        numbers.put(scale.range.max, fmt::format("{:.4g}", scale.range.max));
        for (const double tick : scale_ticks(scale.range.min, scale.range.max, 5))
            numbers.put(tick, fmt::format("{:.4g}", tick));
    } else {
        draw_text({corner.x, corner.y + height + scaled(5)}, width, colors::text,
                  fmt::format("{:.4g} everywhere", scale.range.min));
    }
    ImGui::Dummy({width, height + scaled(6) + ImGui::GetTextLineHeight()});
    ImGui::PopFont();
}

void choose_field(Display& display, std::span<const FamilyField> fields) {
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##field", display.field.c_str())) return;
    for (const FamilyField& field : fields) {
        const std::string& name = field.label.name;
        const bool chosen = name == display.field;
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        // Drawn by hand: Dear ImGui takes what follows a "##" in a label for no part of it.
        ImGui::PushID(&field);
        if (ImGui::Selectable("", chosen)) display.field = name;
        if (chosen) ImGui::SetItemDefaultFocus();
        draw_text(corner, ImGui::GetItemRectSize().x, colors::text, name);
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

/// Each map with its colours beside its name.
void choose_map(ColorMap& map) {
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##map", std::string(name_of(map)).c_str())) return;
    for (const ColorMap each : color_maps()) {
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        if (ImGui::Selectable(std::string(name_of(each)).c_str(), each == map)) map = each;
        const float width = scaled(90);
        const float height = ImGui::GetTextLineHeight();
        draw_colors(
            {corner.x + ImGui::GetContentRegionAvail().x - width, corner.y + std::round(height * 0.2F)},
            {width, std::round(height * 0.6F)}, {.map = each, .range = {}});
    }
    ImGui::EndCombo();
}

/// The ends of a locked range; what is no range, as while one is typed, is not taken.
void lock_range(Display& display) {
    ImGui::Checkbox("Lock range", &display.range_locked);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Keeps these values. Otherwise the range is that of all keys.");
    if (!display.range_locked) return;
    float ends[] = {display.scale.range.min, display.scale.range.max};
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::InputFloat2("##range", ends, "%.5g")) return;
    if (std::isfinite(ends[0]) && std::isfinite(ends[1]) && ends[0] < ends[1])
        display.scale.range = {ends[0], ends[1]};
}

}  // namespace

void field_panel(Display& display, std::span<const FamilyField> fields, std::string_view key_without) {
    choose_field(display, fields);
    const FamilyField* const field = find_field(fields, display.field);
    if (field == nullptr) return;
    if (!key_without.empty()) {
        ImGui::PushTextWrapPos(0);
        ImGui::PushStyleColor(ImGuiCol_Text, colors::notice);
        ImGui::TextUnformatted(fmt::format("{} does not have this field.", key_without).c_str());
        ImGui::PopStyleColor();
        ImGui::PopTextWrapPos();
    }
    if (field->label.kind == FieldKind::color) return;
    choose_map(display.scale.map);
    ImGui::Spacing();
    scale_legend(display.scale);
    lock_range(display);
}

}  // namespace interleaf
