// End-to-end tests of faults that once ended the program, and of failures at any point.
#include <fstream>
#include <initializer_list>
#include <string>
#include <vector>

#include "e2e/person.h"
#include "scratch_folder.h"
#include <X11/keysym.h>
#include <doctest/doctest.h>

using namespace interleaf;
using State = RunningViewer::State;

namespace {

namespace fs = std::filesystem;

void color_by(const RunningViewer& viewer, const char* coloring) {
    viewer.point_at(view_middle(viewer.state()));
    while (viewer.state()["display"]["coloring"] != coloring) {
        const State before = viewer.state();
        viewer.press(XK_c);
        viewer.wait_for("the next coloring",
                        [&](const State& s) { return s["display"] != before["display"]; });
    }
}

/// Checks that the program answers: waits until it has seen the pointer elsewhere.
void check_alive(const RunningViewer& viewer) {
    viewer.point_at(view_middle(viewer.state()) + glm::vec2(7, 9));
    viewer.point_at(view_middle(viewer.state()));
}

}  // namespace

TEST_CASE("while the surface is colored by origin, the shown key can be undone and redone") {
    const RunningViewer viewer;
    color_by(viewer, "origin");
    viewer.press(XK_k, XK_Control_L);
    const State kept = wait_for_keys(viewer, 6);
    viewer.click(row_pixel(kept, 5));
    viewer.wait_for("the blend alone", [](const State& s) { return s["active"] == State({"blend"}); });
    viewer.press(XK_z, XK_Control_L);
    const State undone = wait_for_keys(viewer, 5);
    CHECK(undone["active"].size() == 1);
    check_alive(viewer);
    viewer.press(XK_y, XK_Control_L);
    wait_for_keys(viewer, 6);
    check_alive(viewer);
}

TEST_CASE("fewer keys can replace a document colored by origin, or by a field that a key lacks") {
    const ScratchFolder home;
    const RunningViewer viewer(home.path());
    color_by(viewer, "origin");
    State state = viewer.state();
    viewer.click(domain_pixel(state, {0.5F, 0.1F}));
    viewer.wait_for("three keys", [](const State& s) { return s["active"].size() == 3; });
    viewer.drop(std::vector{builtin_file("star.ilh")}, view_middle(state));
    wait_for_keys(viewer, 1);
    check_alive(viewer);

    // The last of three keys lacks the field, and the panel names it. Then the document has only one key.
    std::vector<fs::path> files;
    for (const char* name : {"1", "2", "3"}) {
        files.push_back(home.path() / (std::string("flow.") + name + ".obj"));
        const char* const color = name[0] == '3' ? "" : " 1 0 0";
        std::ofstream(files.back()) << "v 1 1 1" << color << "\nv -1 -1 1" << color << "\nv -1 1 -1" << color
                                    << "\nv 1 -1 -1" << color << "\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    }
    viewer.drop(files, view_middle(state));
    state = wait_for_keys(viewer, 3);
    color_by(viewer, "field");
    viewer.press(XK_End);
    viewer.wait_for("the key without colors", [](const State& s) { return s["active"].back() == "flow.3"; });
    viewer.drop(std::vector{files.front()}, view_middle(state));
    wait_for_keys(viewer, 1);
    check_alive(viewer);
}

TEST_CASE("text typed while a mouse button is held beside the field is kept") {
    const RunningViewer viewer;
    State state = viewer.state();
    viewer.click(row_pixel(state, 1));
    viewer.wait_for("a selected key", [](const State& s) { return s["selected"] == 1; });
    viewer.press(XK_F2);
    viewer.type("a");
    viewer.point_at({30, 400});
    viewer.set_button(1, true);
    viewer.wait_for("no field", [](const State& s) { return s["takes_text"] == false; });
    viewer.type_keys("bc");
    check_alive(viewer);
    viewer.set_button(1, false);
    viewer.type("d");
    // Undo goes back at most to the point at which the field took these letters.
    for (const KeyName key : std::initializer_list<KeyName>{XK_z, XK_z, XK_z, XK_y, XK_y, XK_y}) {
        viewer.press(key, XK_Control_L);
        check_alive(viewer);
    }
    viewer.press(XK_Return);
    state = viewer.wait_for("another name", [](const State& s) { return s["document"]["changed"] == true; });
    CHECK(state["document"]["keys"][1] == "abcd");
}

TEST_CASE("text typed in one question cannot be undone in the next") {
    const RunningViewer viewer;
    State state = viewer.state();
    viewer.click(row_pixel(state, 1));
    viewer.wait_for("a selected key", [](const State& s) { return s["selected"] == 1; });
    viewer.press(XK_F2);
    viewer.type("a long name");
    viewer.press(XK_Return);
    viewer.wait_for("another name", [](const State& s) { return s["document"]["keys"][1] == "a long name"; });
    viewer.press(XK_z, XK_Control_L);
    viewer.wait_for("its own", [](const State& s) { return s["document"]["keys"][1] == "bone"; });
    viewer.press(XK_F2);
    wait_for_question(viewer);
    for (const KeyName key : std::initializer_list<KeyName>{XK_z, XK_y, XK_z}) {
        viewer.press(key, XK_Control_L);
        check_alive(viewer);
    }
    viewer.press(XK_Return);
    wait_for_no_question(viewer);
    CHECK(viewer.state()["document"]["keys"][1] == "bone");
}

#ifndef INTERLEAF_SANITIZE
TEST_CASE("when memory runs out, the window keeps its document and saves it for recovery") {
    const ScratchFolder home;
    RunningViewer viewer(home.path());
    viewer.point_at(view_middle(viewer.state()));
    viewer.press(XK_k, XK_Control_L);
    const State kept = wait_for_keys(viewer, 6);
    viewer.settled_picture();
    const fs::path large = home.path() / "large.ilh";
    const std::string command =
        std::string(INTERLEAF_PROGRAM " make sphere --leaves 2e6 -o ") + large.string();
    REQUIRE(std::system(command.c_str()) == 0);
    viewer.limit_memory(24 << 20);  // enough for a thread, not for the key
    viewer.drop(std::vector{large}, row_pixel(kept, 1));
    const State failed = viewer.wait_for("a message", [](const State& s) {
        return s["message"].get<std::string>().find("not enough memory") != std::string::npos;
    });
    viewer.limit_memory(0);
    CHECK(failed["notice"] == false);
    CHECK(family_of(failed) == family_of(kept));
    CHECK(failed["document"]["undo"] == "Keep blend");
    viewer.wait_for("the recovery", [&](const State&) {
        std::error_code ignored;
        for (const auto& entry : fs::directory_iterator(home.path() / "interleaf" / "recovery", ignored))
            if (fs::exists(entry.path() / "recovery.json")) return true;
        return false;
    });

    // The action that failed succeeds now.
    check_alive(viewer);
    viewer.press(XK_Escape);
    viewer.wait_for("no message", [](const State& s) { return s["message"] == ""; });
    viewer.drop(std::vector{large}, row_pixel(kept, 1));
    wait_for_keys(viewer, 7);
    check_alive(viewer);
}
#endif
