#include "ui/panels/weights_panel.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "family/weight_edits.h"
#include "render/palette.h"
#include "ui/panels/key_picker.h"
#include "ui/widgets/command_keys.h"
#include "ui/widgets/section.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {

namespace {

/// A family with more keys shows only the active ones.
constexpr std::size_t max_slider_rows = 12;

/// Smallest weight and sum that are not written as 0, and smallest difference from 1 that counts.
constexpr double shown_weight = 0.0005;

constexpr float grab_width = 4;

std::string sum_text(const WeightsPanel& panel) {
    const double sum = sum_of(panel.weights);
    const std::string text = std::abs(sum - 1) < shown_weight
                                 ? "sum 1"
                                 : fmt::format("sum {:.3f}", std::abs(sum) < shown_weight ? 0.0 : sum);
    const std::size_t keys = panel.family.keys.size();
    return keys > max_slider_rows ? fmt::format("{} of {}, {}", panel.weights.size(), keys, text) : text;
}

/// The buttons of the drivers in a row, each as wide as its label needs.
std::optional<std::size_t> driver_buttons(const WeightsPanel& panel) {
    std::optional<std::size_t> pressed;
    ImGui::PushFont(small_font());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {scaled(2), scaled(4)});
    const float gap = scaled(2);
    const auto count = static_cast<float>(panel.drivers.size());
    float labels = 0;
    for (const DriverButton& button : panel.drivers) labels += text_size(button.label).x;
    const float padding = (ImGui::GetContentRegionAvail().x - labels - gap * (count - 1)) / count;
    for (std::size_t i = 0; i < panel.drivers.size(); ++i) {
        const DriverButton& button = panel.drivers[i];
        if (i > 0) ImGui::SameLine(0, gap);
        const bool is_chosen = i == panel.driver;
        if (is_chosen) {
            ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colors::chosen_hovered);
        }
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Button(button.label, {std::floor(text_size(button.label).x + padding), 0})) pressed = i;
        ImGui::PopID();
        if (is_chosen) ImGui::PopStyleColor(2);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", button.tooltip.c_str());
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
    return pressed;
}

/// The dot in the color of \p key, filled while the key is active.
/// \return whether it was pressed
bool activity_dot(std::size_t key, bool is_active, bool is_only, float height) {
    const float radius = scaled(4);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton("active", {scaled(16), height});
    const bool is_hovered = ImGui::IsItemHovered() || (shows_focus() && ImGui::IsItemFocused());
    const ImVec2 center{corner.x + radius + scaled(1), corner.y + height / 2};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (is_active)
        list.AddCircleFilled(center, radius, to_color(key_color(key)));
    else
        list.AddCircle(center, radius - 0.5F, to_color(key_color(key), 0.6F), 0, scaled(1));
    if (is_hovered) {
        list.AddCircle(center, radius + scaled(2), colors::text, 0, scaled(1));
        ImGui::SetTooltip("%s", is_only     ? "The only key of the blend stays in it"
                                : is_active ? "Take this key out of the blend"
                                            : "Add this key to the blend, with weight 0");
    }
    return pressed && !is_only;
}

/// Draws the bar of a slider, which the slider then covers without a frame of its own.
void draw_bar(std::size_t key, double value, bool is_active, float width, float height) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    list.AddRectFilled(corner, {corner.x + width, corner.y + height}, colors::well, scaled(3));
    const float part = std::clamp(static_cast<float>(value), 0.0F, 1.0F);
    // Dear ImGui keeps the grab 2 pixels within the frame.
    const float end = 2 + scaled(grab_width) / 2 + part * (width - 4 - scaled(grab_width));
    if (is_active && part > 0)
        list.AddRectFilled(corner, {corner.x + end, corner.y + height}, to_color(key_color(key), 0.45F),
                           scaled(3));
}

/// Whether the frame at the cursor, \p width wide, was double-clicked.
bool is_double_clicked(float width) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    return ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && ImGui::IsWindowHovered() &&
           ImGui::IsMouseHoveringRect(corner, {corner.x + width, corner.y + ImGui::GetFrameHeight()});
}

/// \return the new value, if the user changed it
std::optional<double> weight_slider(std::size_t key, double value, bool is_active, float width) {
    const bool is_typing = ImGui::TempInputIsActive(ImGui::GetID("##weight"));
    if (!is_typing) draw_bar(key, value, is_active, width, ImGui::GetFrameHeight());
    if (std::abs(value) < shown_weight && !is_typing) value = 0;
    const ImVec4 none{0, 0, 0, 0};
    const ImVec4 hovered{1, 1, 1, 0.06F};
    ImGui::PushStyleColor(ImGuiCol_FrameBg, is_typing ? ImGui::GetStyleColorVec4(ImGuiCol_FrameBg) : none);
    ImGui::PushStyleColor(ImGuiCol_FrameBgHovered,
                          is_typing ? ImGui::GetStyleColorVec4(ImGuiCol_FrameBg) : hovered);
    ImGui::PushStyleColor(ImGuiCol_FrameBgActive, hovered);
    ImGui::PushStyleColor(ImGuiCol_SliderGrab,
                          ImGui::ColorConvertU32ToFloat4(to_color(key_color(key), is_active ? 1.0F : 0.0F)));
    ImGui::PushStyleColor(ImGuiCol_SliderGrabActive,
                          ImGui::ColorConvertU32ToFloat4(to_color(key_color(key))));
    ImGui::PushStyleColor(ImGuiCol_Text, is_active || is_typing ? colors::text : colors::dim_text);
    ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, scaled(grab_width));
    ImGui::SetNextItemWidth(width);
    constexpr double low = 0;
    constexpr double high = 1;
    const double before = value;
    const char* const format = is_active || is_typing ? "%.3f" : "–";
    // A click with Ctrl lets Dear ImGui's slider become a field to type in; so does a double click here.
    bool& ctrl = ImGui::GetIO().KeyCtrl;
    const bool had_ctrl = ctrl;
    ctrl = ctrl || is_double_clicked(width);
    const bool is_changed =
        ImGui::SliderScalar("##weight", ImGuiDataType_Double, &value, &low, &high, format);
    ctrl = had_ctrl;
    const bool is_activated = ImGui::IsItemActivated();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(6);
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
        ImGui::SetTooltip("Drag; double-click or press Enter to type any number");
    if (!std::isfinite(value)) return std::nullopt;
    value = std::clamp(value, -max_typed_weight, max_typed_weight);
    const bool becomes_active = is_activated && !is_active;
    return (is_changed && value != before) || becomes_active ? std::optional(value) : std::nullopt;
}

/// A key with its dot, its name and its slider.
void weight_row(const WeightsPanel& panel, std::size_t key, WeightsPanelResult& result) {
    const auto weight = std::ranges::find(panel.weights, key, &Weight::key);
    const bool is_active = weight != panel.weights.end();
    ImGui::PushID(static_cast<int>(key));
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::GetFrameHeight();
    if (activity_dot(key, is_active, is_active && panel.weights.size() == 1, height))
        result.weights = is_active ? without_key(panel.weights, key) : with_weight(panel.weights, key, 0);
    ImGui::SameLine(0, 0);
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float name_width = std::round(width * 0.48F) - scaled(16);
    const std::string& name = panel.family.keys[key].name;
    draw_text({corner.x, corner.y + ImGui::GetStyle().FramePadding.y}, name_width - scaled(8),
              is_active ? colors::text : colors::dim_text, shortened(name, name_width - scaled(8)));
    ImGui::Dummy({name_width, height});
    if (ImGui::IsItemHovered() && text_size(name).x > name_width - scaled(8))
        ImGui::SetTooltip("%s", name.c_str());
    ImGui::SameLine(0, 0);
    if (const auto value =
            weight_slider(key, is_active ? weight->value : 0, is_active, ImGui::GetContentRegionAvail().x))
        result.weights = with_weight(panel.weights, key, *value);
    ImGui::PopID();
}

void weight_buttons(const WeightsPanel& panel, WeightsPanelResult& result) {
    const bool is_long = panel.family.keys.size() > max_slider_rows;
    const float gap = scaled(2);
    const float count = is_long ? 3 : 2;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap * (count - 1)) / count);
    if (is_long) {
        if (const auto key = key_picker("Add key...", panel.family, panel.weights, width))
            result.weights = with_weight(panel.weights, *key, 0);
        ImGui::SameLine(0, gap);
    }
    const std::optional<Weights> summed = summed_to_one(panel.weights);
    const bool has_effect = summed && std::abs(sum_of(panel.weights) - 1) > 1e-12;
    ImGui::BeginDisabled(!has_effect);
    if (ImGui::Button("Sum to 1", {width, 0})) result.weights = summed;
    ImGui::EndDisabled();
    tooltip(has_effect ? with_keys("Divide all weights by their sum", {"Make weights sum to 1"})
            : summed   ? "The weights sum to 1"
                       : "The weights sum to 0, so no factor makes their sum 1");
    ImGui::SameLine(0, gap);
    ImGui::BeginDisabled(!panel.can_reset);
    result.resets = ImGui::Button("Reset", {width, 0});
    ImGui::EndDisabled();
    tooltip(with_keys("Back to the weights before the first slider moved", {"Reset weights"}));
}

}  // namespace

WeightsPanelResult weights_panel(const WeightsPanel& panel) {
    WeightsPanelResult result;
    if (!section("Weights", sum_text(panel),
                 "The part of each key in the blend. Drag a weight, or double-click to type it."))
        return result;
    result.driver = driver_buttons(panel);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {scaled(6), scaled(1)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, scaled(3)});
    if (panel.family.keys.size() > max_slider_rows) {
        for (const Weight& weight : panel.weights) weight_row(panel, weight.key, result);
    } else {
        for (std::size_t key = 0; key < panel.family.keys.size(); ++key) weight_row(panel, key, result);
    }
    ImGui::PopStyleVar(2);
    ImGui::PushFont(small_font());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {scaled(2), scaled(3)});
    weight_buttons(panel, result);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    return result;
}

}  // namespace interleaf
