#include "ui/panels/help_overlay.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "text/fuzzy_match.h"
#include "ui/widgets/command_keys.h"
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
    {"Wheel in the domain", "Show a smaller or larger part"},
    {"Drag on the timeline", "Go to a time"},
    {"Wheel on the timeline", "Show a shorter or longer part of the times"},
    {"Drag a weight", "Blend by hand; a double click types a number"},
    {"Drag a key", "Move it in the list, onto the timeline or into the domain"},
    {"Ctrl+click a key", "Take it into the blend, or out of it"},
    {"Right click", "Menu of a key, of its mark on the timeline, or of a vertex of the domain"},
};

void show_help_row(std::string_view left, std::string_view right) {
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

/// A row of the help.
struct HelpRow {
    std::string_view section;
    std::string_view action;  ///< shortcut, or what the mouse does
    std::string_view effect;
};

/// All rows that match the search, the mouse first.
std::vector<HelpRow> matching_rows(const HelpOverlay& help) {
    std::vector<HelpRow> rows;
    rows.reserve(std::size(mouse) + help.entries.size());
    const auto add = [&](const HelpRow& row, std::string_view name) {
        const std::string all = fmt::format("{} {} {} {}", row.section, name, row.action, row.effect);
        if (contains_words(help.search, all)) rows.push_back(row);
    };
    for (const auto& [action, effect] : mouse) add({"Mouse", action, effect}, "");
    for (const MenuEntry& entry : help.entries)
        add({entry.menu, entry.shortcut, entry.description}, entry.name);
    return rows;
}

/// \return whether there is a row
bool help_rows(const HelpOverlay& help) {
    const std::vector<HelpRow> rows = matching_rows(help);
    const float key_width = text_size("Ctrl+Right or Page Down").x + scaled(12);
    for (auto begin = rows.begin(); begin != rows.end();) {
        const auto end = std::find_if(begin, rows.end(),
                                      [&](const HelpRow& row) { return row.section != begin->section; });
        if (begin != rows.begin()) ImGui::Spacing();
        heading(begin->section);
        if (begin_rows(std::string(begin->section).c_str(), key_width)) {
            for (; begin != end; ++begin) show_help_row(begin->action, begin->effect);
            ImGui::EndTable();
        }
        begin = end;
    }
    return !rows.empty();
}

/// The search field and the button that closes the help.
HelpResult help_head(const HelpOverlay& help) {
    HelpResult result;
    const float close = text_size("Close").x + 2 * ImGui::GetStyle().FramePadding.x;
    std::string search = help.search;
    if (help.takes_focus) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - close - ImGui::GetStyle().ItemSpacing.x);
    if (ImGui::InputTextWithHint("##search", with_keys("Search the help", {"Find"}).c_str(), &search))
        result.search = search;
    ImGui::SameLine();
    result.closed = ImGui::Button("Close");
    ImGui::Spacing();
    return result;
}

}  // namespace

HelpResult help_overlay(const HelpOverlay& help, const Rect& area) {
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
    HelpResult result = help_head(help);
    ImGui::BeginChild("rows", {0, 0}, false, ImGuiWindowFlags_NoNav);
    if (!help_rows(help)) ImGui::TextDisabled("Nothing matches");
    ImGui::EndChild();
    ImGui::End();
    ImGui::PopStyleVar(2);
    return result;
}

}  // namespace interleaf
