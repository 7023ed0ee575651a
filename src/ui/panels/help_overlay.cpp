#include "ui/panels/help_overlay.h"

#include <algorithm>
#include <utility>

#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

namespace {

constexpr std::pair<std::string_view, std::string_view> mouse[] = {
    {"Drag", "Orbit"},
    {"Right drag, Shift+drag", "Pan"},
    {"Ctrl+right drag", "Roll"},
    {"Wheel", "Zoom towards the pointer, or away from it"},
    {"Double click", "See the whole surface"},
    {"Drag with the brush", "Refine; with Shift or Alt coarsen. The wheel with Shift changes the radius"},
    {"Drag in the domain", "Move the point; a click jumps"},
    {"Drag on the timeline", "Go to a time"},
};

void row(std::string_view left, std::string_view right) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colors::accent);
    ImGui::TextUnformatted(left.data(), left.data() + left.size());
    ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(right.data(), right.data() + right.size());
    ImGui::PopTextWrapPos();
}

bool begin_rows(const char* name, float key_width) {
    if (!ImGui::BeginTable(name, 2)) return false;
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, key_width);
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    return true;
}

}  // namespace

bool help_overlay(std::span<const MenuEntry> entries, const Rect& area) {
    const float width = std::min(scaled(560), area.width - scaled(24));
    const float height = std::min(scaled(676), area.height - scaled(24));
    ImGui::SetNextWindowPos({area.x + area.width / 2, area.y + area.height / 2}, ImGuiCond_Always,
                            {0.5F, 0.5F});
    ImGui::SetNextWindowSize({width, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {scaled(18), scaled(14)});
    ImGui::Begin("Keys and mouse", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    const float key_width = text_size("Ctrl+Right or Page Down").x + scaled(12);
    std::string_view menu;
    for (const MenuEntry& entry : entries) {
        if (entry.menu != menu) {
            if (!menu.empty()) {
                ImGui::EndTable();
                ImGui::Spacing();
            }
            menu = entry.menu;
            heading(menu);
            begin_rows(std::string(menu).c_str(), key_width);
        }
        row(entry.shortcut, entry.description);
    }
    if (!menu.empty()) ImGui::EndTable();
    ImGui::Spacing();
    heading("Mouse");
    if (begin_rows("mouse", key_width)) {
        for (const auto& [action, what] : mouse) row(action, what);
        ImGui::EndTable();
    }
    ImGui::Spacing();
    const bool is_closed = ImGui::Button("Close");
    ImGui::End();
    ImGui::PopStyleVar(2);
    return is_closed;
}

}  // namespace interleaf
