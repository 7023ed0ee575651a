#include "ui/panels/field_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/core.h>
#include <imgui.h>

#include "family/vector_field.h"
#include "ui/widgets/command_keys.h"
#include "ui/widgets/scale_legend.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {

namespace {

void choose_field(Display& display, std::span<const FamilyField> fields) {
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##field", display.field.c_str()))
        return tooltip("The field that colors the surface");
    for (const FamilyField& field : fields) {
        const std::string& name = field.label.name;
        const bool chosen = name == display.field;
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        // Draw the name by hand: Dear ImGui does not show the part of a label after "##".
        ImGui::PushID(&field);
        if (ImGui::Selectable("", chosen)) display.field = name;
        if (chosen) ImGui::SetItemDefaultFocus();
        draw_name(corner, ImGui::GetItemRectSize().x, colors::text, name);
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

/// Offers the color maps, each with its colors beside its name.
void choose_map(ColorMap& map) {
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##map", std::string(name_of(map)).c_str()))
        return tooltip("Colors of the field; coolwarm has its middle at 0");
    for (const ColorMap each : color_maps()) {
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        if (ImGui::Selectable(std::string(name_of(each)).c_str(), each == map)) map = each;
        const float width = scaled(90);
        const float height = ImGui::GetTextLineHeight();
        draw_scale_colors(
            {corner.x + ImGui::GetContentRegionAvail().x - width, corner.y + std::round(height * 0.2F)},
            {width, std::round(height * 0.6F)}, {.map = each, .range = {}});
    }
    ImGui::EndCombo();
}

/// Offers to lock the range, and to edit its ends.
void lock_range(Display& display) {
    ImGui::Checkbox("Lock range", &display.range_locked);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Keeps this range. Otherwise the range covers the values of all keys.");
    if (!display.range_locked) return;
    edit_range(display.scale);
}

/// Offers a logarithmic scale, which needs a range above 0.
void choose_logarithm(ColorScale& scale) {
    const bool can_be = scale.range.min > 0 && scale.offset == 0;
    if (!can_be) ImGui::BeginDisabled();
    ImGui::Checkbox("Logarithmic", &scale.is_logarithmic);
    if (!can_be) ImGui::EndDisabled();
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip(can_be ? "Equal steps of color are equal factors of the value."
                                 : "Needs a range above 0: lock the range, and type where it begins.");
}

void choose_height(Display& display) {
    float& height = display.height;
    heading("Height", height > 0 ? fmt::format("{:.0f} %", 100 * height) : "flat");
    ImGui::SetNextItemWidth(-1);
    if (ImGui::SliderFloat("##height", &height, 0, 1, "")) display.raised_by.clear();
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "Raises the surface by the field: the range becomes this part of the surface's size.");
}

/// Shows the name of \p field over its legend, with its unit on a button.
/// \return whether the button is pressed
bool show_title(const FamilyField& field) {
    const std::string unit = field.unit.empty() ? "no unit" : field.unit;
    const glm::vec2 padding(ImGui::GetStyle().FramePadding.x, ImGui::GetStyle().FramePadding.y);
    const float row = ImGui::GetContentRegionAvail().x;
    const float width = std::min(text_size(unit).x + 2 * padding.x + 1, row / 2);
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    draw_name({corner.x, corner.y + padding.y}, row - width - scaled(6), colors::text, field.label.name);
    ImGui::SetCursorScreenPos({corner.x + row - width, corner.y});
    const bool is_pressed = ImGui::Button("##unit", {width, 0});
    tooltip(with_keys("Unit of the field: type another one", {"Unit of field"}));
    draw_text({corner.x + row - width + padding.x, corner.y + padding.y}, width - 2 * padding.x,
              field.unit.empty() ? colors::dim_text : colors::text, unit);
    return is_pressed;
}

}  // namespace

Display field_panel(const Display& shown, std::span<const FamilyField> fields, std::string_view key_without,
                    bool can_rise, bool& asks_for_unit) {
    Display display = shown;
    choose_field(display, fields);
    const FamilyField* const field = find_field(fields, display.field);
    if (field == nullptr) return display;
    if (!key_without.empty()) {
        wrapped_text(fmt::format("{} does not have this field.", key_without), colors::notice);
    }
    if (field->label.kind == FieldKind::color) return display;
    choose_map(display.scale.map);
    ImGui::Spacing();
    asks_for_unit = show_title(*field);
    scale_legend(display.scale);
    lock_range(display);
    choose_logarithm(display.scale);
    if (const auto vector = vector_of(fields, display.field)) {
        if (ImGui::Checkbox("Arrows", &display.arrows)) display.arrow_parts = {};
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Draws the vectors %s.", vector->name.c_str());
    }
    if (can_rise) choose_height(display);
    return display;
}

}  // namespace interleaf
