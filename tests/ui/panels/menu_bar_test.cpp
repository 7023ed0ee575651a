// Tests of the menu bar.
#include "ui/panels/menu_bar.h"

#include <optional>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <imgui_internal.h>

#include "ui/headless_gui.h"
#include "ui/widgets/style.h"

using namespace interleaf;

namespace {

std::optional<std::size_t> chosen_in_frame(HeadlessGui& gui, const std::vector<MenuEntry>& entries,
                                           glm::vec2 pointer, bool is_down) {
    gui.begin_frame(pointer, is_down);
    const MenuBarResult result = menu_bar(entries, {}, "title");
    gui.end_frame();
    return result.chosen;
}

}  // namespace

TEST_CASE(
    "a menu that is higher than the window stays below the menu bar, and the opening click chooses nothing") {
    HeadlessGui gui({800, 300});
    std::vector<MenuEntry> entries;
    entries.reserve(40);
    for (int i = 0; i < 40; ++i) {
        MenuEntry entry;
        entry.menu = "Long";
        entry.name = "Entry " + std::to_string(i);
        entries.push_back(std::move(entry));
    }
    const glm::vec2 title(24, 8);
    for (int frame = 0; frame < 3; ++frame) chosen_in_frame(gui, entries, title, false);
    for (int frame = 0; frame < 4; ++frame) CHECK_FALSE(chosen_in_frame(gui, entries, title, true));
    for (int frame = 0; frame < 4; ++frame) CHECK_FALSE(chosen_in_frame(gui, entries, title, false));
    const glm::vec2 first(40, 44);
    for (int frame = 0; frame < 3; ++frame) chosen_in_frame(gui, entries, first, false);
    chosen_in_frame(gui, entries, first, true);
    CHECK(chosen_in_frame(gui, entries, first, false) == 0U);
}

TEST_CASE("the whole name of an entry has room in the menu, also behind a double hash") {
    HeadlessGui gui({800, 300});
    const std::string name = "Undo Rename to a##key with a name that is long";
    const std::vector<MenuEntry> entries{{.menu = "Edit", .name = name, .shortcut = {}, .description = {}}};
    for (int frame = 0; frame < 6; ++frame) chosen_in_frame(gui, entries, {24, 8}, frame == 2);
    gui.begin_frame({24, 8}, false);
    CHECK(menu_bar(entries, {}, "title").chosen == std::nullopt);
    const ImGuiWindow* const menu = ImGui::FindWindowByName("##Menu_00");
    REQUIRE(menu != nullptr);
    CHECK(menu->Active);
    CHECK(menu->Size.x > text_size(name).x);
    gui.end_frame();
}
