#include "ui/panels/menu_bar.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>
#include <imgui_internal.h>

#include "ui/widgets/glyphs.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Of an entry that is a name, at scale 1.
constexpr float max_item_width = 460;

/// Shows \p text beside the menu while the pointer is at its last entry; the entries stay visible.
void describe(std::string_view text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    const ImVec2 corner = ImGui::GetWindowPos();
    const float right = corner.x + ImGui::GetWindowWidth() + scaled(4);
    const float width = text_size(text).x + 2 * ImGui::GetStyle().WindowPadding.x;
    const bool has_room = right + width <= ImGui::GetIO().DisplaySize.x;
    ImGui::SetNextWindowPos({has_room ? right : corner.x - scaled(4), ImGui::GetItemRectMin().y},
                            ImGuiCond_Always, {has_room ? 0.0F : 1.0F, 0.25F});
    ImGui::SetTooltip("%.*s", static_cast<int>(text.size()), text.data());
}

/// A label as wide as \p name, of which nothing is visible.
std::string blank_label(const std::string& name) {
    const auto blanks = static_cast<std::size_t>(std::ceil(text_size(name).x / text_size(" ").x));
    return std::string(blanks, ' ') + "##" + name;
}

bool menu_item(const MenuEntry& entry) {
    need_glyphs(entry.name);
    // Dear ImGui hides the part of a label after "##", which the name of a key may have, so this draws it.
    const bool hides_part = entry.name.find("##") != std::string::npos;
    const std::string label = hides_part ? blank_label(entry.name) : entry.name;
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const bool is_chosen = ImGui::MenuItem(label.c_str(), entry.shortcut.c_str(), entry.on, entry.enabled);
    if (hides_part)
        draw_text(corner, text_size(label.substr(0, label.find("##"))).x,
                  ImGui::GetColorU32(entry.enabled ? ImGuiCol_Text : ImGuiCol_TextDisabled), entry.name);
    describe(entry.description);
    return is_chosen;
}

std::optional<std::size_t> show_submenu(const Submenu& submenu) {
    std::optional<std::size_t> chosen;
    if (!ImGui::BeginMenu(submenu.name.c_str(), !submenu.items.empty())) return chosen;
    for (std::size_t item = 0; item < submenu.items.size(); ++item) {
        ImGui::PushID(static_cast<int>(item));
        if (name_item(submenu.items[item], scaled(max_item_width))) chosen = item;
        ImGui::PopID();
    }
    ImGui::EndMenu();
    return chosen;
}

/// Lets the next menu scroll where the window has no room for it. Otherwise it would lie under the pointer that
/// opens it, which would then choose an entry.
void keep_below_menu_bar() {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSizeConstraints({0, 0}, {display.x, display.y - menu_bar_height() - scaled(8)});
}

/// Opens the next menu when an arrow to the side leads nowhere in the open menu.
void move_to_menu_beside(const std::vector<std::string>& menus, std::size_t open) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    const ImGuiDir direction = context.NavMoveDir;
    const bool is_aside = direction == ImGuiDir_Left || direction == ImGuiDir_Right;
    if (!is_aside || !ImGui::NavMoveRequestButNoResultYet()) return;
    ImGui::NavMoveRequestCancel();
    context.NavDisableMouseHover = true;  // otherwise the menu under the pointer would open again
    context.NavDisableHighlight = false;
    const std::size_t step = direction == ImGuiDir_Right ? 1 : menus.size() - 1;
    ImGui::OpenPopup(menus[(open + step) % menus.size()].c_str());
}

}  // namespace

std::optional<std::size_t> menu_entries(std::span<const MenuEntry> entries) {
    std::optional<std::size_t> chosen;
    for (std::size_t entry = 0; entry < entries.size(); ++entry)
        if (menu_item(entries[entry])) chosen = entry;
    return chosen;
}

float menu_bar_height() {
    return ImGui::GetFrameHeight();
}

MenuBarResult menu_bar(std::span<const MenuEntry> entries, const Submenu& submenu, std::string_view title,
                       bool opens) {
    MenuBarResult result;
    if (!ImGui::BeginMainMenuBar()) return result;
    if (opens && !entries.empty()) {
        const std::string first(entries.front().menu);
        if (!ImGui::IsPopupOpen(first.c_str())) ImGui::OpenPopup(first.c_str());
    }
    std::vector<std::string> menus;
    std::optional<std::size_t> open_menu;
    for (std::size_t begin = 0; begin < entries.size();) {
        const std::string menu(entries[begin].menu);
        keep_below_menu_bar();
        const bool open = ImGui::BeginMenu(menu.c_str());
        if (open) open_menu = menus.size();
        menus.push_back(menu);
        std::size_t entry = begin;
        for (; entry < entries.size() && entries[entry].menu == entries[begin].menu; ++entry) {
            if (!open) continue;
            if (menu_item(entries[entry])) result.chosen = entry;
            if (submenu.menu == menu && submenu.after == entries[entry].name)
                result.chosen_item = show_submenu(submenu);
        }
        if (open) ImGui::EndMenu();
        begin = entry;
    }
    if (open_menu) move_to_menu_beside(menus, *open_menu);
    const float left = ImGui::GetCursorPosX() + scaled(16);
    const float right = ImGui::GetWindowWidth() - scaled(12);
    const float width = std::min(text_size(title).x, right - left);
    if (width > 0) {
        const float top = ImGui::GetWindowPos().y + ImGui::GetStyle().FramePadding.y;
        draw_name({right - width, top}, width, colors::dim_text, title);
    }
    ImGui::EndMainMenuBar();
    return result;
}

}  // namespace interleaf
