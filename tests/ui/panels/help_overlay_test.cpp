// Tests of the help: its search, and its button.
#include "ui/panels/help_overlay.h"

#include <doctest/doctest.h>
#include <imgui.h>

#include "ui/headless_gui.h"
#include "ui/widgets/style.h"

using namespace interleaf;

namespace {

constexpr Rect help_area{0, 24, 1280, 776};
constexpr Rect help_rows_area{370, 110, 520, 600};

/// The rows of the sample that the help shows, told apart by the accent color of their shortcuts.
bool shows_rows(const std::string& search) {
    const MenuEntry entry{
        .menu = "Edit", .name = "Undo", .shortcut = "Ctrl+Z", .description = "Undo the last edit"};
    HeadlessGui gui({1280, 800});
    for (int i = 0; i < 3; ++i) {
        gui.begin_frame({0, 0}, false);
        help_overlay({.entries = {&entry, 1}, .search = search}, help_area);
        gui.end_frame();
    }
    return gui.has_color(colors::accent, help_rows_area);
}

}  // namespace

TEST_CASE("the help shows the rows that contain every word, in any column") {
    for (const char* search : {"", "undo", "ctrl+z", "EDIT last", "wheel timeline", "orbit"}) {
        CAPTURE(search);
        CHECK(shows_rows(search));
    }
    for (const char* search : {"undo orbit", "xyz"}) {
        CAPTURE(search);
        CHECK_FALSE(shows_rows(search));
    }
}

TEST_CASE("letters that are typed into the field become the search") {
    HeadlessGui gui({1280, 800});
    std::string search;
    for (int i = 0; i < 6; ++i) {
        if (i == 3) ImGui::GetIO().AddInputCharacter('u');
        gui.begin_frame({0, 0}, false);
        const HelpResult result =
            help_overlay({.entries = {}, .search = search, .takes_focus = i == 0}, help_area);
        gui.end_frame();
        if (result.search) search = *result.search;
    }
    CHECK(search == "u");
}
