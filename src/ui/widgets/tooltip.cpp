#include "ui/widgets/tooltip.h"

#include <imgui.h>

namespace interleaf {

void tooltip(const char* text) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !ImGui::IsItemActive())
        ImGui::SetTooltip("%s", text);
}

}  // namespace interleaf
