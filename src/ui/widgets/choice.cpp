#include "ui/widgets/choice.h"

#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

std::size_t choice(const char* name, std::span<const char* const> labels, std::size_t chosen, float width) {
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
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colors::chosen_hovered);
        }
        if (ImGui::Button(labels[i], {button, 0})) now = i;
        if (i == chosen) ImGui::PopStyleColor(2);
    }
    ImGui::EndGroup();
    ImGui::PopID();
    return now;
}

}  // namespace interleaf
