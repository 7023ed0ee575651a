// End-to-end tests of menus and the keyboard: an open menu receives all keys.
#include <chrono>
#include <initializer_list>
#include <thread>

#include "e2e/person.h"
#include <X11/keysym.h>
#include <doctest/doctest.h>

using namespace interleaf;
using State = RunningViewer::State;

namespace {

State wait_for_menu(const RunningViewer& viewer) {
    return viewer.wait_for("a menu", [](const State& s) { return !s["rects"]["popup"].is_null(); });
}

State wait_for_no_menu(const RunningViewer& viewer) {
    return viewer.wait_for("no menu", [](const State& s) { return s["rects"]["popup"].is_null(); });
}

/// Waits, because a key pressed again at once counts as held.
void wait_as_between_keys() {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
}

}  // namespace

TEST_CASE("Esc closes a menu and nothing else") {
    const RunningViewer viewer;
    viewer.press(XK_h);
    viewer.wait_for("the help", [](const State& s) { return s["help"] == true; });
    viewer.click({20, 10});
    wait_for_menu(viewer);
    viewer.press(XK_Escape);
    State state = wait_for_no_menu(viewer);
    CHECK(state["help"] == true);
    viewer.press(XK_Escape);
    viewer.wait_for("no help", [](const State& s) { return s["help"] == false; });

    viewer.click(row_pixel(state, 1), 3);
    wait_for_menu(viewer);
    viewer.press(XK_Escape);
    state = wait_for_no_menu(viewer);
    CHECK(state["selected"] == 1);
    CHECK(state["document"]["changed"] == false);
}

TEST_CASE("arrows move in an open menu and Enter chooses, and time and camera do not change") {
    const RunningViewer viewer;
    const State start = viewer.state();
    const auto nothing_has_moved = [&](const State& s) {
        return s["time"] == start["time"] && s["eye"] == start["eye"] && s["document"] == start["document"];
    };
    // From the first menu to the next, and back.
    viewer.click({20, 10});
    const State file = wait_for_menu(viewer);
    viewer.press(XK_Right);
    const State edit = viewer.wait_for("the next menu", [&](const State& s) {
        return !s["rects"]["popup"].is_null() && s["rects"]["popup"] != file["rects"]["popup"];
    });
    CHECK(nothing_has_moved(edit));
    viewer.press(XK_Left);
    viewer.wait_for("the first menu again",
                    [&](const State& s) { return s["rects"]["popup"] == file["rects"]["popup"]; });
    viewer.press(XK_Escape);
    CHECK(nothing_has_moved(wait_for_no_menu(viewer)));

    // The second entry of the key's menu: duplicate.
    viewer.click(row_pixel(start, 2), 3);
    wait_for_menu(viewer);
    viewer.press(XK_Down);
    wait_as_between_keys();
    viewer.press(XK_Down);
    wait_as_between_keys();
    viewer.press(XK_Return);
    const State state = wait_for_keys(viewer, 6);
    CHECK(state["document"]["undo"] == "Duplicate cushion");
    CHECK(state["document"]["changed"] == true);
    CHECK(state["time"] == start["time"]);
    wait_for_no_menu(viewer);

    // Afterwards the arrows are for the timeline again.
    viewer.press(XK_Right);
    viewer.wait_for("another time", [&](const State& s) { return s["time"] != start["time"]; });
}

TEST_CASE("Alt opens the first menu, and F6 gives the keyboard to the panels") {
    const RunningViewer viewer;
    const State start = viewer.state();
    viewer.press(XK_Alt_L);
    wait_for_menu(viewer);
    viewer.press(XK_Escape);
    wait_for_no_menu(viewer);

    viewer.press(XK_F6);
    constexpr int most_rows_above = 8;  // headings and buttons above the first key
    for (int row = 0; row < most_rows_above && viewer.state()["selected"].is_null(); ++row) {
        wait_as_between_keys();
        viewer.press(XK_Down);
    }
    State state = viewer.wait_for("a selected key", [](const State& s) { return !s["selected"].is_null(); });
    CHECK(state["time"] == start["time"]);
    CHECK(state["driver"] == "key");
    viewer.press(XK_Escape);
    viewer.settled_picture();  // the keyboard is the document's again
    viewer.press(XK_space);
    viewer.wait_for("playback", [](const State& s) { return s["playing"] == true; });
}

TEST_CASE("the search for commands runs what is found, and receives all keys meanwhile") {
    const RunningViewer viewer;
    viewer.press(XK_p, XK_Control_L);
    viewer.wait_for("the search", [](const State& s) { return s["asking"] == true; });
    for (const KeyName letter : std::initializer_list<KeyName>{XK_w, XK_i, XK_r, XK_e}) {
        viewer.press(letter);
        wait_as_between_keys();
    }
    CHECK(viewer.state()["display"]["wireframe"] == false);
    viewer.press(XK_Return);
    viewer.wait_for("the wireframe", [](const State& s) { return s["display"]["wireframe"] == true; });
}
