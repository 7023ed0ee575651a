// End-to-end tests of the refine brush: a stroke with the mouse, undone, and one that is cancelled.
#include <cstddef>

#include "e2e/person.h"
#include "e2e/running_viewer.h"
#include <X11/keysym.h>
#include <doctest/doctest.h>
#include <glm/vec2.hpp>

using namespace interleaf;
using State = RunningViewer::State;

TEST_CASE(
    "a stroke of the brush refines the key under the pointer as one step, and Esc takes a stroke back") {
    const RunningViewer viewer;
    viewer.click(row_pixel(viewer.state(), 2));
    viewer.press(XK_x);
    State state = viewer.wait_for("the brush", [](const State& s) { return s["brush"] == true; });
    const std::size_t leaves = state["leaves"];
    const State eye = state["eye"];
    const glm::vec2 middle = view_middle(state);

    viewer.drag(middle - glm::vec2(40, 0), middle + glm::vec2(40, 0));
    state = viewer.wait_for("the stroke", [&](const State& s) {
        return s["document"]["undo"] == "Refine cushion" && s["late"] == false && s["leaves"] > leaves;
    });
    CHECK(state["eye"] == eye);
    CHECK(state["selected"] == 2);
    CHECK(state["driver"] == "key");
    const std::size_t refined = state["leaves"];

    viewer.press(XK_z, XK_Control_L);
    state = viewer.wait_for("undo", [&](const State& s) { return s["leaves"] == leaves; });
    CHECK(state["document"]["undo"].is_null());
    CHECK(state["document"]["changed"] == false);
    viewer.press(XK_y, XK_Control_L);
    viewer.wait_for("redo", [&](const State& s) { return s["leaves"] == refined; });

    viewer.point_at(middle + glm::vec2(0, 40));
    viewer.set_button(1, true);
    viewer.wait_for("a second stroke", [&](const State& s) { return s["leaves"] > refined; });
    viewer.press(XK_Escape);
    state = viewer.wait_for("the stroke taken back", [&](const State& s) { return s["leaves"] == refined; });
    CHECK(state["document"]["redo"].is_null());
    viewer.set_button(1, false);
    viewer.press(XK_Escape);
    viewer.wait_for("no brush", [](const State& s) { return s["brush"] == false; });
}
