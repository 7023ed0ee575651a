#include "ui/widgets/choice.h"

#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

namespace {

constexpr ImU32 chosen_hovered = IM_COL32(66, 118, 184, 255);

}  // namespace

std::size_t choice(const char* name, std::span<const char* const> labels, std::size_t chosen, float width,
                   std::span<const char* const> tooltips) {
    ImGui::PushID(name);
    ImGui::BeginGroup();
    const float gap = scaled(2);
    const auto count = static_cast<float>(labels.size());
    const float button = (width - gap * (count - 1)) / count;
    std::size_t now = chosen;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        if (i == chosen) {
            // Also under the pointer: a chosen button must not look like a button that is not chosen.
            ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, chosen_hovered);
        }
        if (ImGui::Button(labels[i], {button, 0})) now = i;
        if (i == chosen) ImGui::PopStyleColor(2);
        if (i < tooltips.size() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tooltips[i]);
    }
    ImGui::EndGroup();
    ImGui::PopID();
    return now;
}

}  // namespace interleaf
