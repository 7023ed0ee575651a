// End-to-end tests of fitting meshes in the window: the offer, by the keyboard alone, and its result.
#include <cstdlib>
#include <fstream>
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

namespace fs = std::filesystem;

/// Small meshes of two shapes, in \p folder, with different faces and file formats.
std::vector<fs::path> unlike_meshes(const fs::path& folder) {
    std::vector<fs::path> meshes{folder / "star.obj", folder / "cushion.ply"};
    for (const fs::path& mesh : meshes) {
        const std::string command =
            fmt::format("'{0}' make {1} --leaves 2500 -o '{2}.ilh' && '{0}' export '{2}.ilh' -o '{2}'",
                        INTERLEAF_PROGRAM, mesh.stem().string(), mesh.string());
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

/// The turns in the offer after the second of two meshes is turned about z.
State turns(const char* degrees) {
    return State::array({State::array({"y", "0"}), State::array({"z", degrees})});
}

/// Goes to the row named \p name, which is the next row or, with \p back, the previous row.
void go_to_row(const RunningViewer& viewer, const char* name, bool back = false) {
    viewer.press(XK_Tab, back ? XK_Shift_L : 0);
    wait_for_offered(viewer, "row", name);
}

/// Goes to the row named `match`, which is next, and turns matching off. It would take most of the time of the fit.
void turn_matching_off(const RunningViewer& viewer) {
    go_to_row(viewer, "match");
    CHECK(viewer.state()["offer"]["match_parts"] == true);
    viewer.press(XK_space);
    wait_for_offered(viewer, "match_parts", false);
}

State wait_for_compared(const RunningViewer& viewer, const char* mesh) {
    return viewer.wait_for(mesh,
                           [&](const State& s) { return s["comparing"] == true && s["compared"] == mesh; });
}

/// Waits for the notice that the fitted keys can be compared.
State wait_for_fit_told(const RunningViewer& viewer) {
    return viewer.wait_for("how near the keys are", [](const State& s) {
        const auto message = s["message"].get<std::string>();
        return s["asking"] == false && s["notice"] == true &&
               message.find("been fitted. Compare") != std::string::npos &&
               message.find("box diagonal from the mesh") != std::string::npos;
    });
}

/// Waits until the fitted keys have been played from the first to the last, without further input.
void wait_for_played(const RunningViewer& viewer) {
    viewer.wait_for("the morph on its way", [](const State& s) {
        return s["playing"] == true && s["time"].get<double>() > 0 && s["weights"].size() == 2;
    });
    viewer.wait_for("its end", [](const State& s) {
        return s["playing"] == false && s["time"] == 1 &&
               s["weights"] == State({{"star", 0.0}, {"cushion", 1.0}});
    });
}

/// Compares the fitted keys star and cushion with their meshes, looks at both, and goes back.
void compare_and_return(const RunningViewer& viewer) {
    wait_for_fit_told(viewer);
    viewer.press(XK_m);
    State state = wait_for_compared(viewer, "star.obj");
    CHECK(state["message"] == "");
    const State document = state["document"];
    viewer.point_at({view_middle(state).x, 40});
    const Picture star = viewer.settled_picture();
    viewer.press(XK_Right);
    wait_for_compared(viewer, "cushion.ply");
    const Picture cushion = viewer.changed_picture(star);
    viewer.press(XK_Right);
    wait_for_compared(viewer, "star.obj");
    CHECK(viewer.shows(star));
    viewer.press(XK_c);
    viewer.changed_picture(star);
    viewer.press(XK_c);
    CHECK(viewer.shows(star));

    // Both sides turn together, whichever side is dragged.
    const float eye = state["eye"][0].get<float>();
    const glm::vec2 left = view_middle(state) - glm::vec2(200, 0);
    viewer.drag(left, left + glm::vec2(60, 10));
    viewer.wait_for("another view", [&](const State& s) { return s["eye"][0].get<float>() != eye; });

    // The document is neither visible nor editable.
    viewer.press(XK_k, XK_Control_L);
    viewer.press(XK_Escape);
    state = viewer.wait_for("the document", [](const State& s) { return s["comparing"] == false; });
    CHECK(state["document"] == document);
    viewer.press(XK_m);
    wait_for_compared(viewer, "star.obj");
    viewer.press(XK_m);
    viewer.wait_for("the document", [](const State& s) { return s["comparing"] == false; });
}

}  // namespace

TEST_CASE("dropped meshes with different faces are fitted by Enter alone, unless the user declines") {
    const ScratchFolder home;
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
    CHECK(state["document"]["keys"] == State({"star", "cushion"}));
    CHECK(state["document"]["times"] == State({{0, "star"}, {1, "cushion"}}));
    CHECK(state["document"]["changed"] == true);
    CHECK(state["document"]["folder"].is_null());
    CHECK(state["leaves"] > 19'000);

    // The morph is played once. The comparison remains available.
    wait_for_fit_told(viewer);
    wait_for_played(viewer);
    viewer.wait_for("the notice gone by itself", [](const State& s) { return s["message"] == ""; });
    CHECK(viewer.state()["comparing"] == false);
    viewer.press(XK_m);
    viewer.wait_for("the comparison", [](const State& s) { return s["comparing"] == true; });
}

TEST_CASE("in the offer, the keyboard chooses leaves, roots and the turn of each mesh") {
    const ScratchFolder home;
    const std::vector<fs::path> meshes = unlike_meshes(home.path());
    const RunningViewer viewer(home.path(), meshes);
    wait_for_offer(viewer);
    CHECK(viewer.state()["document"]["name"] == "Five keys");

    // Fewer leaves than roots are refused.
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
    turn_matching_off(viewer);
    go_to_row(viewer, "landmarks");
    go_to_row(viewer, "size");
    viewer.press(XK_space);
    wait_for_offered(viewer, "same_size", false);
    viewer.press(XK_space);
    wait_for_offered(viewer, "same_size", true);
    go_to_row(viewer, "center");
    CHECK(viewer.state()["offer"]["same_center"] == true);
    go_to_row(viewer, "meshes");
    viewer.press(XK_Right);
    wait_for_offered(viewer, "mesh", 1);
    go_to_row(viewer, "up");
    viewer.press(XK_Right);
    wait_for_offered(viewer, "ups", State({"Y", "Z"}));
    go_to_row(viewer, "axis");
    viewer.press(XK_Right);
    wait_for_offered(viewer, "turns", turns("0"));
    go_to_row(viewer, "degrees");
    viewer.type("-90");
    wait_for_offered(viewer, "turns", turns("-90"));
    viewer.press(XK_Return);
    const State state = wait_for_keys(viewer, 2);
    CHECK(state["document"]["keys"] == State({"star", "cushion"}));

    CHECK(state["document"]["roots"] == 20);
    viewer.wait_for("the surface of the two",
                    [](const State& s) { return s["leaves"] > 1'900 && s["leaves"] <= 4'000; });
    compare_and_return(viewer);
}

TEST_CASE("landmarks are set from proposals by the keyboard, undone, and used by the fit and the family") {
    const ScratchFolder home;
    std::vector<fs::path> meshes{home.path() / "cushion.obj", home.path() / "sphere.ply"};
    for (const fs::path& mesh : meshes) {
        const std::string command = fmt::format("'{}' export --weights {}=1 -o '{}'", INTERLEAF_PROGRAM,
                                                mesh.stem().string(), mesh.string());
        REQUIRE(std::system(command.c_str()) == 0);
    }
    const RunningViewer viewer(home.path(), meshes);
    wait_for_offer(viewer);
    viewer.type("500");
    go_to_row(viewer, "roots");
    turn_matching_off(viewer);
    go_to_row(viewer, "landmarks");
    viewer.press(XK_Return);
    const auto wait_for_points = [&](const char* what, const State& places) {
        viewer.wait_for(what, [&](const State& s) {
            if (!s["landmarks"].is_object() || s["landmarks"]["points"].size() != places.size()) return false;
            for (std::size_t k = 0; k < places.size(); ++k)
                if (s["landmarks"]["points"][k]["places"] != places[k]) return false;
            return true;
        });
    };
    viewer.wait_for("the blend", [](const State& s) {
        return s["landmarks"].is_object() && s["landmarks"]["made"] == true;
    });
    viewer.press(XK_space);
    wait_for_points("a point on the first mesh", State::array({State::array({true, false})}));
    viewer.press(XK_Right);
    viewer.press(XK_space);
    wait_for_points("its partner", State::array({State::array({true, true})}));
    viewer.press(XK_z, XK_Control_L);
    wait_for_points("no partner", State::array({State::array({true, false})}));
    viewer.press(XK_y, XK_Control_L);
    wait_for_points("the partner again", State::array({State::array({true, true})}));
    viewer.press(XK_F2);
    viewer.wait_for("the name", [](const State& s) { return s["takes_text"] == true; });
    viewer.type("tip");
    viewer.press(XK_Return);
    viewer.wait_for("the new name",
                    [](const State& s) { return s["landmarks"]["points"][0]["name"] == "tip"; });

    // The landmarks of the sphere become a file, and come back from it.
    viewer.wait_for("the name to rest", [](const State& s) { return s["takes_text"] == false; });
    viewer.press(XK_s, XK_Control_L);
    viewer.wait_for("a name for the file", [](const State& s) { return s["takes_text"] == true; });
    viewer.press(XK_Return);
    viewer.wait_for("the file", [&](const State& s) {
        return s["takes_text"] == false && fs::exists(home.path() / "sphere.json");
    });
    viewer.press(XK_Delete);
    wait_for_points("no point", State::array());
    const State dialog = viewer.state()["rects"]["popup"];
    viewer.press(XK_o, XK_Control_L);
    viewer.wait_for("the file browser", [&](const State& s) {
        return s["rects"]["popup"].is_array() && s["rects"]["popup"] != dialog;
    });
    viewer.type_keys("/");
    viewer.wait_for("the path", [](const State& s) { return s["takes_text"] == true; });
    viewer.type((home.path() / "sphere.json").string().substr(1));
    viewer.press(XK_Return);
    wait_for_points("the point of the file", State::array({State::array({false, true})}));
    CHECK(viewer.state()["landmarks"]["points"][0]["name"] == "tip");
    viewer.press(XK_z, XK_Control_L);
    wait_for_points("no point again", State::array());
    viewer.press(XK_z, XK_Control_L);
    wait_for_points("both points again", State::array({State::array({true, true})}));
    viewer.press(XK_Return);
    viewer.wait_for("the offer", [](const State& s) { return s["landmarks"].is_null(); });
    viewer.press(XK_Tab);
    wait_for_offered(viewer, "row", "size");
    viewer.press(XK_Return);
    const State state = wait_for_keys(viewer, 2);
    CHECK(state["document"]["landmarks"] == State::array({"tip"}));
}

TEST_CASE("a mesh dropped on the list is fitted over the family's roots; a refused mesh changes nothing") {
    const ScratchFolder home;
    const std::vector<fs::path> meshes = unlike_meshes(home.path());
    const fs::path& cushion = meshes.back();
    const RunningViewer viewer(home.path());
    const State before = viewer.state();
    // An .obj is a key by itself, but not a key of this family.
    viewer.drop(std::vector{meshes.front()}, row_pixel(before, 1));
    wait_for_offer(viewer);
    viewer.press(XK_Escape);
    wait_for_no_question(viewer);
    CHECK(viewer.state()["document"] == before["document"]);

    viewer.drop(std::vector{cushion}, row_pixel(before, 1));
    wait_for_offer(viewer);
    // There are no roots and no meshes to choose. After the number come the choices that depend on the other
    // keys.
    for (const char* row : {"match", "landmarks", "size", "center", "up", "axis"}) go_to_row(viewer, row);
    viewer.press(XK_Return);
    State state = wait_for_keys(viewer, 6);
    CHECK(state["document"]["keys"][5] == "cushion 2");
    CHECK(state["document"]["roots"] == before["document"]["roots"]);
    CHECK(state["document"]["undo"] == "Add cushion");
    CHECK(wait_for_fit_told(viewer)["playing"] == false);
    // The notice lies in the lower left corner of the view, and a click dismisses it.
    const State& view = state["rects"]["view"];
    viewer.click({view[0].get<float>() + 30, view[1].get<float>() + view[3].get<float>() - 30});
    viewer.wait_for("no message", [](const State& s) { return s["message"] == ""; });
    viewer.press(XK_z, XK_Control_L);
    state = wait_for_keys(viewer, 5);
    viewer.press(XK_m);

    const fs::path sheet = home.path() / "sheet.off";
    std::ofstream(sheet) << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    viewer.drop(std::vector{sheet}, view_middle(state));
    wait_for_offer(viewer);
    CHECK(viewer.state()["comparing"] == false);
    viewer.press(XK_Return);
    const State refused = viewer.wait_for("a message", [](const State& s) {
        return s["message"].get<std::string>().find("sheet.off") != std::string::npos;
    });
    CHECK(family_of(refused) == family_of(before));
    CHECK(refused["document"]["changed"] == false);
}

TEST_CASE("the offer shows what is lost and added, and Fit waits until the user allows it") {
    const ScratchFolder home;
    // A box without a lid, and a small box beside it.
    const fs::path mesh = home.path() / "boxes.obj";
    std::ofstream file(mesh);
    for (const double size : {2.0, 1.0})
        for (int i = 0; i < 8; ++i)
            file << fmt::format("v {} {} {}\n", (i & 1) * size + 4 * size, (i >> 1 & 1) * size,
                                (i >> 2) * size);
    file << "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\n"
            "f 9 11 12 10\nf 13 14 16 15\nf 9 10 14 13\nf 11 15 16 12\nf 9 13 15 11\nf 10 12 16 14\n";
    file.close();
    const fs::path copy = home.path() / "copy.off";
    std::ofstream(copy) << "OFF 4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    const RunningViewer viewer(home.path(), {mesh, copy});
    wait_for_offer(viewer);
    const auto fault_with = [](const char* words) {
        return [words](const State& s) {
            return s["offer"].is_object() &&
                   s["offer"]["fault"].get<std::string>().find(words) != std::string::npos;
        };
    };
    viewer.wait_for("a remark about parts", fault_with("A key is made of one part"));
    go_to_row(viewer, "roots");
    turn_matching_off(viewer);
    for (const char* row : {"landmarks", "size", "center", "meshes", "up", "axis", "degrees", "parts"})
        go_to_row(viewer, row);
    viewer.press(XK_Return);
    CHECK(viewer.state()["offer"].is_object());
    viewer.press(XK_space);
    viewer.wait_for("a remark about holes", fault_with("A key is closed"));
    go_to_row(viewer, "holes");
    viewer.press(XK_space);
    wait_for_offered(viewer, "fault", "");
    viewer.press(XK_Return);
    CHECK(wait_for_keys(viewer, 2)["document"]["keys"] == State({"boxes", "copy"}));
}

TEST_CASE("unsaved changes are asked about before the offer to fit, and a canceled fit keeps them") {
    const ScratchFolder home;
    const std::vector<fs::path> meshes = unlike_meshes(home.path());
    const RunningViewer viewer(home.path());
    viewer.point_at(view_middle(viewer.state()));
    viewer.press(XK_k, XK_Control_L);
    const State before = wait_for_keys(viewer, 6);

    viewer.drop(meshes, view_middle(before));
    wait_for_question(viewer);
    CHECK(viewer.state()["offer"].is_null());
    viewer.type_keys("d");
    viewer.wait_for("the offer", [](const State& s) { return s["offer"].is_object(); });

    // With so many leaves there is time to cancel.
    viewer.type("5000000");
    wait_for_offered(viewer, "leaves", "5000000");
    viewer.press(XK_Return);
    viewer.wait_for("the work", [](const State& s) { return s["asking"] == true && s["offer"].is_null(); });
    viewer.press(XK_Escape);
    wait_for_no_question(viewer);
    CHECK(viewer.state()["document"] == before["document"]);
    CHECK(viewer.state()["message"] == "");

    // The same with one click on "Fit", without canceling.
    viewer.drop(meshes, view_middle(before));
    wait_for_question(viewer);
    viewer.type_keys("d");
    const State offered = viewer.wait_for(
        "the offer", [](const State& s) { return s["offer"].is_object() && !s["rects"]["popup"].is_null(); });
    go_to_row(viewer, "roots");
    turn_matching_off(viewer);
    const State& popup = offered["rects"]["popup"];
    const glm::vec2 corner(popup[0].get<float>() + popup[2].get<float>(),
                           popup[1].get<float>() + popup[3].get<float>());
    viewer.click(corner - glm::vec2(150, 25));
    CHECK(wait_for_keys(viewer, 2)["document"]["keys"] == State({"star", "cushion"}));
    wait_for_played(viewer);
}
