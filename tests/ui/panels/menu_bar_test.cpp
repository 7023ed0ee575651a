// Tests of the menu bar.
#include "ui/panels/menu_bar.h"

#include <optional>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "ui/headless_gui.h"

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
