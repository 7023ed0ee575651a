// Tests of parts of panels that can be closed.
#include "ui/widgets/section.h"

#include <doctest/doctest.h>
#include <imgui.h>

#include "ui/headless_gui.h"
#include "ui/widgets/gui_state.h"
#include "ui/widgets/style.h"

using namespace interleaf;

namespace {

/// Shows a panel with one section in both passes of a frame.
/// \return whether the section was open in the second pass
bool show(HeadlessGui& gui, glm::vec2 pointer, bool is_down) {
    bool is_open = false;
    const auto panel = [&] {
        begin_panel("panel", {0, 0, 200, 100});
        is_open = section("Part", "remark");
        end_panel();
    };
    gui.begin_frame(pointer, is_down);
    panel();
    gui.begin_drawing();
    panel();
    gui.end_frame();
    return is_open;
}

}  // namespace

TEST_CASE("a click on its heading closes a section, and another click opens it") {
    HeadlessGui gui({200, 100});
    const glm::vec2 title{16, 14};
    CHECK(show(gui, {0, 0}, false));
    show(gui, title, false);
    CHECK(show(gui, title, true));
    CHECK_FALSE(show(gui, title, false));
    CHECK(gui_state()->closed_sections.contains("Part"));
    CHECK_FALSE(show(gui, title, false));
    show(gui, title, true);
    CHECK(show(gui, title, false));
    CHECK(gui_state()->closed_sections.empty());
}

TEST_CASE("a section that the settings name is closed from the begin, and its remark is no button") {
    HeadlessGui gui({200, 100});
    gui_state()->closed_sections.insert("Part");
    CHECK_FALSE(show(gui, {0, 0}, false));
    const glm::vec2 remark{180, 14};
    show(gui, remark, false);
    show(gui, remark, true);
    CHECK_FALSE(show(gui, remark, false));
}
