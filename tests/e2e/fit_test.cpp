// End-to-end tests of fitting meshes in the window: the offer, by the keyboard alone, and what comes of it.
#include <cstdlib>
#include <string>
#include <vector>

#include "e2e/person.h"
#include <X11/keysym.h>
#include <doctest/doctest.h>
#include <fmt/core.h>

using namespace interleaf;
using State = RunningViewer::State;

namespace {

namespace fs = std::filesystem;

/// Two meshes of the built-in family's keys in \p folder, of different faces and kinds of file.
std::vector<fs::path> unlike_meshes(const fs::path& folder) {
    std::vector<fs::path> meshes{folder / "star.obj", folder / "bone.ply"};
    for (const fs::path& mesh : meshes) {
        const std::string command = fmt::format("'{}' export --weights {}=1 -o '{}'", INTERLEAF_PROGRAM,
                                                mesh.stem().string(), mesh.string());
        REQUIRE(std::system(command.c_str()) == 0);
    }
    return meshes;
}

void wait_for_offer(const RunningViewer& viewer) {
    wait_for_question(viewer);
    CHECK(viewer.state()["offer"].is_object());
}

void wait_for_offered(const RunningViewer& viewer, const char* what, const State& value) {
    viewer.wait_for(what,
                    [&](const State& s) { return s["offer"].is_object() && s["offer"][what] == value; });
}

/// What is offered when the second of two meshes is turned about z.
State turns(const char* degrees) {
    return State::array({State::array({"y", "0"}), State::array({"z", degrees})});
}

/// Moves on to the row called \p name, the next one or the one before.
void go_to_row(const RunningViewer& viewer, const char* name, bool back = false) {
    viewer.press(XK_Tab, back ? XK_Shift_L : 0);
    wait_for_offered(viewer, "row", name);
}

}  // namespace

TEST_CASE("dropped meshes whose faces differ are fitted by Enter alone, unless that is declined") {
    const TemporaryFolder home;
    const std::vector<fs::path> meshes = unlike_meshes(home.path());
    const RunningViewer viewer(home.path());
    const State before = family_of(viewer.state());
    viewer.drop(meshes, view_middle(viewer.state()));
    wait_for_offer(viewer);
    viewer.press(XK_Escape);
    wait_for_no_question(viewer);
    CHECK(family_of(viewer.state()) == before);
    CHECK(viewer.state()["document"]["changed"] == false);

    viewer.drop(meshes, view_middle(viewer.state()));
    wait_for_offer(viewer);
    viewer.press(XK_Return);
    const State state = wait_for_keys(viewer, 2);
    CHECK(state["document"]["keys"] == State({"star", "bone"}));
    CHECK(state["document"]["times"] == State({{0, "star"}, {1, "bone"}}));
    CHECK(state["document"]["changed"] == true);
    CHECK(state["document"]["folder"].is_null());
    CHECK(state["leaves"] > 19'000);
    CHECK(state["message"] == "");
}

TEST_CASE("in the offer, leaves, roots and the turn of each mesh are chosen by the keyboard") {
    const TemporaryFolder home;
    const std::vector<fs::path> meshes = unlike_meshes(home.path());
    const RunningViewer viewer(home.path(), meshes);
    wait_for_offer(viewer);
    CHECK(viewer.state()["document"]["name"] == "Five keys");

    // Fewer leaves than roots are not taken.
    viewer.type("19");
    wait_for_offered(viewer, "leaves", "19");
    go_to_row(viewer, "roots");
    viewer.press(XK_Right);
    wait_for_offered(viewer, "roots", 1);
    viewer.press(XK_Return);
    go_to_row(viewer, "number", true);
    viewer.type("2000");
    wait_for_offered(viewer, "leaves", "2000");

    go_to_row(viewer, "roots");
    go_to_row(viewer, "meshes");
    viewer.press(XK_Right);
    wait_for_offered(viewer, "mesh", 1);
    go_to_row(viewer, "axis");
    viewer.press(XK_Right);
    wait_for_offered(viewer, "turns", turns("0"));
    go_to_row(viewer, "degrees");
    viewer.type("-90");
    wait_for_offered(viewer, "turns", turns("-90"));
    viewer.press(XK_Return);
    const State state = wait_for_keys(viewer, 2);
    CHECK(state["document"]["keys"] == State({"star", "bone"}));

    CHECK(state["document"]["roots"] == 20);
    CHECK(state["leaves"] > 1'900);
    CHECK(state["leaves"] <= 4'000);
}
