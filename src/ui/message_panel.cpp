#include "ui/message_panel.h"

#include <algorithm>

#include <imgui.h>

#include "ui/style.h"

namespace interleaf {

void message_panel(std::string& message, const Rect& area) {
    if (message.empty()) return;
    const float margin = scaled(12);
    const float width = std::min(scaled(640), area.width - 2 * margin);
    ImGui::SetNextWindowPos({area.x + area.width / 2, area.y + margin}, ImGuiCond_Always, {0.5F, 0});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, area.height - 2 * margin});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(6));
    ImGui::PushStyleColor(ImGuiCol_Border, colors::notice);
    ImGui::Begin("message", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(message.data(), message.data() + message.size());
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    if (ImGui::Button("Copy")) ImGui::SetClipboardText(message.c_str());
    ImGui::SameLine();
    if (ImGui::Button("Dismiss")) message.clear();
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

}  // namespace interleaf
