// End-to-end tests of composing a family with the mouse, the keys and the menus, and of undoing, redoing,
// saving and opening it.
#include <string>
#include <vector>

#include "e2e/person.h"
#include "scratch_folder.h"
#include <X11/keysym.h>
#include <doctest/doctest.h>
#include <fmt/core.h>

using namespace interleaf;
using State = RunningViewer::State;

namespace {

/// Waits until the last step is named \p name.
State wait_for_step(const RunningViewer& viewer, const std::string& name) {
    return viewer.wait_for(name, [&](const State& s) { return s["document"]["undo"] == name; });
}

void answer(const RunningViewer& viewer, const std::string& text) {
    viewer.type(text);
    viewer.press(XK_Return);
    wait_for_no_question(viewer);
}

void compose_keys(const RunningViewer& viewer) {
    State state = viewer.state();
    viewer.drag(domain_pixel(state, {0.5F, 0.1F}), domain_pixel(state, {0.6F, -0.1F}));
    viewer.press(XK_k, XK_Control_L);
    state = wait_for_step(viewer, "Keep blend");
    CHECK(state["selected"] == 5);
    CHECK(state["document"]["keys"].size() == 6);

    viewer.press(XK_F2);
    answer(viewer, "kept");
    state = wait_for_step(viewer, "Rename blend");
    CHECK(state["document"]["keys"][5] == "kept");

    viewer.press(XK_d, XK_Control_L);
    state = wait_for_step(viewer, "Duplicate kept");
    CHECK(state["document"]["keys"].size() == 7);
    CHECK(state["document"]["keys"][5] == "kept");

    const auto selected = state["selected"].get<int>();
    const std::string name = state["document"]["keys"][static_cast<std::size_t>(selected)];
    viewer.press(XK_Up, XK_Alt_L);
    state = wait_for_step(viewer, "Move " + name);
    CHECK(state["document"]["keys"][static_cast<std::size_t>(selected - 1)] == name);
    CHECK(state["selected"] == selected - 1);

    viewer.drag(row_pixel(state, 0), row_pixel(state, 2));
    state = wait_for_step(viewer, "Move icosahedron");
    CHECK(state["document"]["keys"][2] == "icosahedron");
    CHECK(state["selected"] == 2);
    viewer.press(XK_Down, XK_Alt_L);
    viewer.wait_for("a key moved down",
                    [](const State& s) { return s["document"]["keys"][3] == "icosahedron"; });
}

void compose_times(const RunningViewer& viewer) {
    viewer.press(XK_t);
    answer(viewer, "12.5");
    State state = wait_for_step(viewer, "Put icosahedron on the timeline");
    CHECK(state["document"]["times"].back() == State({12.5, "icosahedron"}));

    viewer.drag(row_pixel(state, 0), track_pixel(state, 5));
    state = wait_for_step(viewer, "Put bone on the timeline");
    CHECK(state["document"]["times"].size() == 8);
    CHECK(state["document"]["times"][3][0].get<double>() == doctest::Approx(5).epsilon(0.01));

    viewer.drag(time_name_pixel(state, 2), time_name_pixel(state, 3));
    state = wait_for_step(viewer, "Move a key in time");
    CHECK(state["document"]["times"][1][0].get<double>() == doctest::Approx(3).epsilon(0.01));
    CHECK(state["document"]["times"][1][1] == "cushion");

    viewer.click(time_name_pixel(state, 8), 3);
    choose_in_menu(viewer, 1, 2);
    state = wait_for_step(viewer, "Take sphere off the timeline");
    CHECK(state["document"]["times"].size() == 7);

    viewer.click(time_name_pixel(state, 10), 3);
    choose_in_menu(viewer, 0, 2);
    answer(viewer, "9.25");
    state = wait_for_step(viewer, "Set the time of star");
    CHECK(state["document"]["times"][5] == State({9.25, "star"}));
}

void compose_domain(const RunningViewer& viewer) {
    viewer.press(XK_d);
    State state = viewer.wait_for("the domain to edit", [](const State& s) { return s["edits_domain"]; });
    const State before = family_of(state);
    viewer.drag(domain_pixel(state, {0, 0}), domain_pixel(state, {0.25F, 0.125F}));
    state = wait_for_step(viewer, "Move a domain vertex");
    CHECK(state["document"]["domain"][4][0].get<double>() == doctest::Approx(0.25).epsilon(0.05));
    const State moved = family_of(state);
    viewer.press(XK_z, XK_Control_L);
    viewer.wait_for("the whole drag undone", [&](const State& s) { return family_of(s) == before; });
    viewer.press(XK_y, XK_Control_L);
    state = viewer.wait_for("it done again", [&](const State& s) { return family_of(s) == moved; });

    // The menu has a heading, then the seven keys: the entry is bone.
    viewer.click(domain_pixel(state, {-0.5F, 0}), 3);
    choose_in_menu(viewer, 1, 8);
    state =
        viewer.wait_for("a new vertex", [](const State& s) { return s["document"]["domain"].size() == 6; });
    CHECK(state["document"]["domain"][5][2] == state["document"]["keys"][0]);

    // Now it also has "Remove vertex" below them.
    viewer.click(domain_pixel(state, {-0.5F, 0}), 3);
    choose_in_menu(viewer, 3, 10);
    state = viewer.wait_for("another key at it", [](const State& s) {
        return s["document"]["domain"][5][2] == s["document"]["keys"][2];
    });

    viewer.click(domain_pixel(state, {0.25F, 0.125F}), 3);
    choose_in_menu(viewer, 9, 10);
    state = wait_for_step(viewer, "Remove a domain vertex");
    CHECK(state["document"]["domain"].size() == 5);

    viewer.drag(row_pixel(state, 4), domain_pixel(state, {1, 1}));
    state = viewer.wait_for("a key dropped on a vertex", [](const State& s) {
        return s["document"]["domain"][2][2] == s["document"]["keys"][4];
    });
    viewer.press(XK_d);
    viewer.wait_for("the point again", [](const State& s) { return !s["edits_domain"]; });
}

void remove_a_key_by_its_menu(const RunningViewer& viewer) {
    const State state = viewer.state();
    const std::string name = state["document"]["keys"][1];
    viewer.click(row_pixel(state, 1), 3);
    // The entries: rename, duplicate, put on timeline, put here, up, down, remove.
    choose_in_menu(viewer, 6, 7);
    const State after = wait_for_step(viewer, "Remove " + name);
    CHECK(after["document"]["keys"].size() == 6);
}

State undo_all(const RunningViewer& viewer) {
    State state = viewer.state();
    while (!state["document"]["undo"].is_null()) {
        viewer.press(XK_z, XK_Control_L);
        state = viewer.wait_for("a step back",
                                [&](const State& s) { return s["document"] != state["document"]; });
    }
    return state;
}

State redo_all(const RunningViewer& viewer) {
    State state = viewer.state();
    while (!state["document"]["redo"].is_null()) {
        viewer.press(XK_z, XK_Control_L, XK_Shift_L);
        state = viewer.wait_for("a step again",
                                [&](const State& s) { return s["document"] != state["document"]; });
    }
    return state;
}

/// Moves the file browser's cursor to \p name by typing \p letters, and presses Enter.
void choose_in_browser(const RunningViewer& viewer, const std::string& letters, const std::string& name) {
    viewer.type_keys(letters);
    viewer.wait_for("the cursor on " + name, [&](const State& s) {
        return s["browsed"].is_string() &&
               std::filesystem::path(s["browsed"].get<std::string>()).filename() == name;
    });
    viewer.press(XK_Return);
}

}  // namespace

TEST_CASE("a composed family is the same after undo, redo, saving and opening") {
    const ScratchFolder home;
    State composed;
    {
        RunningViewer viewer(home.path());
        const State first = family_of(viewer.state());
        compose_keys(viewer);
        compose_times(viewer);
        compose_domain(viewer);
        remove_a_key_by_its_menu(viewer);
        composed = family_of(viewer.state());
        CHECK(composed != first);
        CHECK(viewer.title() == "\u2022 Five keys \u2013 Interleaf");

        const State undone = undo_all(viewer);
        CHECK(family_of(undone) == first);
        CHECK(undone["document"]["changed"] == false);
        CHECK(family_of(redo_all(viewer)) == composed);

        viewer.press(XK_s, XK_Control_L, XK_Shift_L);
        wait_for_question(viewer);
        viewer.type("composed");
        viewer.press(XK_Return);
        const State saved =
            viewer.wait_for("it saved", [](const State& s) { return s["document"]["changed"] == false; });
        CHECK(saved["document"]["folder"] == (home.path() / "composed").string());
        CHECK(viewer.title() == "Five keys (composed) \u2013 Interleaf");
        viewer.press(XK_q, XK_Control_L);
        CHECK(viewer.exit_status() == 0);
    }
    {
        const RunningViewer viewer(home.path(), {home.path() / "composed"});
        CHECK(family_of(viewer.state()) == composed);
        CHECK(viewer.state()["document"]["changed"] == false);
    }
    const RunningViewer viewer(home.path());
    viewer.point_at(view_middle(viewer.state()));
    viewer.press(XK_o, XK_Control_L);
    wait_for_question(viewer);
    choose_in_browser(viewer, "comp", "composed");
    viewer.wait_for("the folder", [&](const State& s) {
        return std::filesystem::path(s["browsed"].get<std::string>()).parent_path() ==
               home.path() / "composed";
    });
    choose_in_browser(viewer, "fam", "family.json");
    wait_for_no_question(viewer);
    const State opened =
        viewer.wait_for("it opened", [](const State& s) { return !s["document"]["folder"].is_null(); });
    CHECK(family_of(opened) == composed);
    CHECK(opened["message"] == "");
}
