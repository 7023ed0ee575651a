#include "ui/widgets/tooltip.h"

#include <imgui.h>

namespace interleaf {

void tooltip(const std::string& text) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !ImGui::IsItemActive())
        ImGui::SetTooltip("%s", text.c_str());
}

}  // namespace interleaf
