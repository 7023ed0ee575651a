#include "ui/menu_bar.h"

#include <imgui.h>

#include "ui/style.h"

namespace interleaf {

MenuBarResult menu_bar(std::span<const MenuEntry> entries, std::string_view title) {
    MenuBarResult result{.height = 0, .chosen = std::nullopt};
    if (!ImGui::BeginMainMenuBar()) return result;
    for (std::size_t begin = 0; begin < entries.size();) {
        const std::string menu(entries[begin].menu);
        const bool open = ImGui::BeginMenu(menu.c_str());
        std::size_t entry = begin;
        for (; entry < entries.size() && entries[entry].menu == entries[begin].menu; ++entry) {
            if (!open) continue;
            const std::string name(entries[entry].name);
            if (ImGui::MenuItem(name.c_str(), entries[entry].shortcut.c_str(), entries[entry].on)) {
                result.chosen = entry;
            }
        }
        if (open) ImGui::EndMenu();
        begin = entry;
    }
    const float left = ImGui::GetCursorPosX() + scaled(16);
    const float right = ImGui::GetWindowWidth() - scaled(12);
    const float width = std::min(text_size(title).x, right - left);
    if (width > 0) {
        const float top = ImGui::GetWindowPos().y + ImGui::GetStyle().FramePadding.y;
        draw_text({right - width, top}, width + 1, colors::dim_text, title);
    }
    result.height = ImGui::GetWindowHeight();
    ImGui::EndMainMenuBar();
    return result;
}

}  // namespace interleaf
