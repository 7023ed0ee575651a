#include "ui/widgets/choice.h"

#include <algorithm>

#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

namespace {

float widest_label(std::span<const char* const> labels) {
    float widest = 0;
    for (const char* const label : labels) widest = std::max(widest, text_size(label).x);
    return widest;
}

}  // namespace

std::size_t choice(const char* name, std::span<const char* const> labels, std::size_t chosen, float width,
                   std::span<const char* const> tips) {
    ImGui::PushID(name);
    ImGui::BeginGroup();
    const float gap = scaled(2);
    const auto count = static_cast<float>(labels.size());
    const float button = (width - gap * (count - 1)) / count;
    const bool is_narrow = widest_label(labels) > button - scaled(6);
    const float height = ImGui::GetFrameHeight();
    if (is_narrow) ImGui::PushFont(small_font());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {scaled(1), ImGui::GetStyle().FramePadding.y});
    std::size_t now = chosen;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        if (i == chosen) {
            // Also under the pointer: a chosen button must not look like a button that is not chosen.
            ImGui::PushStyleColor(ImGuiCol_Button, colors::chosen);
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colors::chosen_hovered);
        }
        if (ImGui::Button(labels[i], {button, height})) now = i;
        if (i == chosen) ImGui::PopStyleColor(2);
        if (i < tips.size() && ImGui::IsItemHovered()) {
            if (is_narrow) ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[0]);
            ImGui::SetTooltip("%s", tips[i]);
            if (is_narrow) ImGui::PopFont();
        }
    }
    ImGui::PopStyleVar();
    if (is_narrow) ImGui::PopFont();
    ImGui::EndGroup();
    ImGui::PopID();
    return now;
}

}  // namespace interleaf
