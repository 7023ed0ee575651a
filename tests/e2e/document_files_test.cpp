// End-to-end tests of the document's files: dropped, opened, changed on disk, left unsaved, lost in a crash
// and recovered.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string_view>
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

bool message_has(const State& state, const std::string& text) {
    return state["message"].get<std::string>().find(text) != std::string::npos;
}

/// A copy of the built-in family in \p folder.
fs::path family_copy(const fs::path& folder) {
    fs::copy(INTERLEAF_BUILTIN_FAMILY, folder);
    return folder;
}

/// Keeps the shown blend as a key, which is an edit.
State keep_blend(const RunningViewer& viewer) {
    viewer.point_at(view_middle(viewer.state()));
    const std::size_t count = viewer.state()["document"]["keys"].size();
    viewer.press(XK_k, XK_Control_L);
    return wait_for_keys(viewer, count + 1);
}

/// The number of pixels in the red that marks an edge. Nothing else in the window has this color.
std::ptrdiff_t count_red(const Picture& picture) {
    return std::ranges::count_if(picture, [](std::uint32_t pixel) {
        const unsigned red = pixel >> 16 & 0xff;
        const unsigned green = pixel >> 8 & 0xff;
        const unsigned blue = pixel & 0xff;
        return red > 60 && red > 3 * green && red > 3 * blue;
    });
}

std::vector<fs::path> recoveries(const fs::path& home) {
    std::vector<fs::path> found;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(home / "interleaf" / "recovery", ignored))
        found.push_back(entry.path());
    return found;
}

/// Waits until an autosave has \p count keys. The recovery's note is written last.
void wait_for_autosave(const RunningViewer& viewer, const fs::path& home, std::size_t count) {
    viewer.wait_for("the autosave", [&](const State&) {
        for (const fs::path& recovery : recoveries(home)) {
            std::ifstream file(recovery / "family" / "family.json");
            const State family = State::parse(file, nullptr, false);
            const bool has_keys = family.is_object() && family["keys"].size() == count;
            if (has_keys && fs::exists(recovery / "recovery.json")) return true;
        }
        return false;
    });
}

/// Names with characters that a list of URIs must escape.
const std::vector<std::string>& awkward_names() {
    static const std::vector<std::string> names{"star 1.ilh", "b\u00f6ne \u2013 two.ilh", "cush%41ion.ilh"};
    return names;
}

}  // namespace

TEST_CASE("a series dropped on the view is imported, colored by its field, and seen from its front") {
    const ScratchFolder home;
    const auto put_step = [&](const char* name, std::string_view triangles) {
        put(home / name,
            fmt::format("# vtk DataFile Version 3.0\ns\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n"
                        "0 0 0 1 0 0 1 1 0 0 1 0 0.5 0.5 0\nPOLYGONS {}POINT_DATA 5\n"
                        "SCALARS u double\nLOOKUP_TABLE default\n0 1 2 1 1\n",
                        triangles));
    };
    put_step("s1.vtk", "2 8\n3 0 1 2\n3 0 2 3\n");
    put_step("s2.vtk", "4 16\n3 4 0 1\n3 4 1 2\n3 4 2 3\n3 4 3 0\n");
    const RunningViewer viewer(home.path());
    viewer.drop(std::vector{home / "s1.vtk", home / "s2.vtk"}, view_middle(viewer.state()));
    State state = wait_for_keys(viewer, 2);
    CHECK(state["document"]["keys"] == State({"s1", "s2"}));
    CHECK(state["display"]["coloring"] == "field");
    CHECK(message_has(state, "2 steps over 2 roots"));
    const auto faces_plane = [](const State& seen, double x, double y) {
        return std::abs(seen["eye"][0].get<double>() - x) < 1e-3 &&
               std::abs(seen["eye"][1].get<double>() - y) < 1e-3;
    };
    state = viewer.wait_for("the front of the plane",
                            [&](const State& seen) { return faces_plane(seen, 0.5, 0.5); });
    // A drag pans: the eye moves along the plane.
    const double distance = state["eye"][2].get<double>();
    const glm::vec2 middle = view_middle(state);
    viewer.drag(middle, middle + glm::vec2(60, 0));
    state = viewer.wait_for("a pan", [&](const State& seen) { return seen["eye"][0].get<double>() < 0.45; });
    CHECK(state["eye"][2].get<double>() == doctest::Approx(distance));
    CHECK(state["eye"][1].get<double>() == doctest::Approx(0.5));
}

TEST_CASE("files dropped on the view open as a new family; files dropped on the list become its keys") {
    const ScratchFolder home;
    const fs::path folder = home.path() / "a folder, 100%";
    fs::create_directory(folder);
    std::vector<fs::path> files;
    const std::vector<std::string> sources{"star.ilh", "bone.ilh", "cushion.ilh"};
    for (std::size_t i = 0; i < sources.size(); ++i) {
        files.push_back(folder / awkward_names()[i]);
        fs::copy(builtin_file(sources[i]), files.back());
    }
    const RunningViewer viewer(home.path());
    viewer.drop(files, view_middle(viewer.state()));
    State state = wait_for_keys(viewer, 3);
    CHECK(state["document"]["keys"] == State({"star 1", "b\u00f6ne \u2013 two", "cush%41ion"}));
    CHECK(state["document"]["times"].size() >= 3);
    CHECK(state["document"]["domain"].size() == 3);
    CHECK(state["document"]["changed"] == false);
    CHECK(state["document"]["folder"].is_null());
    CHECK(state["message"] == "");

    viewer.drop(std::vector{builtin_file("sphere.ilh"), builtin_file("star.ilh")}, row_pixel(state, 1));
    state = wait_for_keys(viewer, 5);
    CHECK(state["document"]["keys"][3] == "sphere");
    CHECK(state["document"]["undo"] == "Add 2 keys");
    CHECK(state["document"]["changed"] == true);
    viewer.press(XK_z, XK_Control_L);
    state = wait_for_keys(viewer, 3);

    // A broken file is refused wherever it is dropped, and changes nothing.
    const fs::path broken = folder / "broken.ilh";
    fs::copy(builtin_file("star.ilh"), broken);
    fs::resize_file(broken, 3000);
    const State before = family_of(state);
    for (const glm::vec2 at : {row_pixel(state, 1), view_middle(state)}) {
        viewer.drop(std::vector{broken}, at);
        state = viewer.wait_for("a message", [&](const State& s) { return message_has(s, broken.string()); });
        CHECK(message_has(state, "size: 3000 bytes, expected"));
        CHECK(family_of(state) == before);
        viewer.press(XK_Escape);
        viewer.wait_for("no message", [](const State& s) { return s["message"] == ""; });
    }

    // Recent files, by the menu: File, then its second line, then the file opened before the last.
    viewer.drop(std::vector{builtin_file("family.json")}, view_middle(state));
    wait_for_keys(viewer, 5);
    viewer.click({20, 10});
    choose_in_menu(viewer, 1, 7);
    const State menu = viewer.wait_for("recent files", [](const State& s) {
        return !s["rects"]["popup"].is_null() && s["rects"]["popup"][0].get<float>() > 40;
    });
    choose_in_menu(viewer, 1, 2);
    state = wait_for_keys(viewer, 1);
    CHECK(state["document"]["keys"] == State({"star 1"}));
}

TEST_CASE("a family folder is opened by its typed path, and by Ctrl+Enter in the list; Enter goes into it") {
    const ScratchFolder home;
    const fs::path folder = family_copy(home.path() / "mine");
    fs::create_directories(home.path() / "other" / "inner");
    const RunningViewer viewer(home.path());
    const auto has_opened = [&](const State& s) { return s["document"]["folder"] == folder.string(); };
    const auto browse = [&] {
        viewer.press(XK_o, XK_Control_L);
        wait_for_question(viewer);
        viewer.wait_for("the folders", [&](const State& s) { return s["browsed"].is_string(); });
    };
    viewer.point_at(view_middle(viewer.state()));
    browse();
    viewer.type_keys("oth");
    viewer.wait_for("the cursor on it",
                    [&](const State& s) { return s["browsed"] == (home.path() / "other").string(); });
    viewer.press(XK_Return);
    viewer.wait_for("the folder", [&](const State& s) {
        return s["browsed"] == (home.path() / "other" / "inner").string();
    });
    viewer.type_keys("/");
    viewer.type(folder.string().substr(1));
    viewer.press(XK_Return);
    wait_for_no_question(viewer);
    viewer.wait_for("the family", has_opened);

    viewer.drop(std::vector{builtin_file("star.ilh")}, view_middle(viewer.state()));
    wait_for_keys(viewer, 1);
    browse();
    // The browser begins in the folder of the previous choice.
    viewer.wait_for("the folder", [&](const State& s) {
        return s["browsed"] == (home.path() / "other" / "inner").string();
    });
    viewer.press(XK_BackSpace);
    viewer.wait_for("the folder above",
                    [&](const State& s) { return s["browsed"] == (home.path() / "other").string(); });
    viewer.type_keys("mi");
    viewer.wait_for("the cursor on it", [&](const State& s) { return s["browsed"] == folder.string(); });
    // Ctrl is held for a while, and released before the program looks again.
    viewer.desktop().set_key(XK_Control_L, true);
    viewer.settled_picture();
    viewer.while_it_is_busy([&] {
        viewer.desktop().set_key(XK_Return, true);
        viewer.desktop().set_key(XK_Return, false);
        viewer.desktop().set_key(XK_Control_L, false);
    });
    wait_for_no_question(viewer);
    viewer.wait_for("the family", has_opened);
    CHECK(viewer.state()["document"]["keys"].size() == 5);
    CHECK(viewer.state()["message"] == "");
}

TEST_CASE("leaving unsaved changes asks: canceling keeps them, declining loses them, saving saves them") {
    const ScratchFolder home;
    const fs::path folder = family_copy(home.path() / "family");
    {
        RunningViewer viewer(home.path(), {folder});
        keep_blend(viewer);
        CHECK(viewer.title() == "\u2022 Five keys (family) \u2013 Interleaf");
        viewer.press(XK_q, XK_Control_L);
        wait_for_question(viewer);
        viewer.press(XK_Escape);
        wait_for_no_question(viewer);
        CHECK(viewer.state()["document"]["keys"].size() == 6);
        wait_for_autosave(viewer, home.path(), 6);
        viewer.press(XK_q, XK_Control_L);
        wait_for_question(viewer);
        viewer.type_keys("d");
        CHECK(viewer.exit_status() == 0);
        CHECK(recoveries(home.path()).empty());
    }
    RunningViewer viewer(home.path(), {folder});
    const State state = viewer.state();
    CHECK(state["asking"] == false);
    CHECK(state["document"]["keys"].size() == 5);
    keep_blend(viewer);
    viewer.press(XK_q, XK_Control_L);
    wait_for_question(viewer);
    viewer.press(XK_Return);
    CHECK(viewer.exit_status() == 0);
    CHECK(recoveries(home.path()).empty());
    std::ifstream file(folder / "family.json");
    CHECK(State::parse(file)["keys"].size() == 6);
}

TEST_CASE("changes lost in a crash are offered, recovered as unsaved, and not offered again after saving") {
    const ScratchFolder home;
    const fs::path folder = family_copy(home.path() / "family");
    State composed;
    {
        RunningViewer viewer(home.path(), {folder});
        composed = family_of(keep_blend(viewer));
        wait_for_autosave(viewer, home.path(), 6);
        viewer.kill();
    }
    {
        // Recover, edit and crash again: there is still one recovery.
        RunningViewer viewer(home.path());
        wait_for_question(viewer);
        viewer.press(XK_Return);
        wait_for_keys(viewer, 6);
        wait_for_no_question(viewer);
        composed = family_of(keep_blend(viewer));
        wait_for_autosave(viewer, home.path(), 7);
        viewer.kill();
        CHECK(recoveries(home.path()).size() == 1);
    }
    {
        RunningViewer viewer(home.path());
        wait_for_question(viewer);
        viewer.press(XK_Return);
        const State state = wait_for_keys(viewer, 7);
        CHECK(family_of(state) == composed);
        CHECK(state["document"]["changed"] == true);
        CHECK(state["document"]["folder"] == folder.string());
        wait_for_no_question(viewer);
        viewer.press(XK_s, XK_Control_L);
        viewer.wait_for("it saved", [](const State& s) { return s["document"]["changed"] == false; });
        viewer.press(XK_q, XK_Control_L);
        CHECK(viewer.exit_status() == 0);
        CHECK(recoveries(home.path()).empty());
    }
    {
        RunningViewer viewer(home.path(), {folder});
        CHECK(viewer.state()["asking"] == false);
        CHECK(family_of(viewer.state()) == composed);
        keep_blend(viewer);
        wait_for_autosave(viewer, home.path(), 8);
        viewer.kill();
    }
    RunningViewer viewer(home.path());
    wait_for_question(viewer);
    viewer.type_keys("d");
    wait_for_no_question(viewer);
    CHECK(recoveries(home.path()).empty());
    CHECK(viewer.state()["document"]["keys"].size() == 5);
    CHECK(viewer.state()["document"]["changed"] == false);
}

TEST_CASE("a message names a file that another program has changed, and Ctrl+R reads it again") {
    const ScratchFolder home;
    const fs::path folder = family_copy(home.path() / "family");
    const RunningViewer viewer(home.path(), {folder});
    const State before = family_of(viewer.state());
    const fs::path file = folder / "family.json";
    State family = State::parse(std::ifstream(file));
    family["name"] = "Renamed elsewhere";
    std::ofstream(file) << family.dump(2);
    const State told =
        viewer.wait_for("a message", [&](const State& s) { return message_has(s, file.string()); });
    CHECK(message_has(told, "Ctrl+R"));
    CHECK(family_of(told) == before);
    viewer.point_at(view_middle(told));
    viewer.press(XK_r, XK_Control_L);
    const State again = viewer.wait_for(
        "the new name", [](const State& s) { return s["document"]["name"] == "Renamed elsewhere"; });
    CHECK(again["document"]["changed"] == false);
    CHECK(again["message"] == "");

    // A file that is broken meanwhile is refused, and the open document stays.
    std::ofstream(file) << "{\"format\": 3";
    viewer.press(XK_r, XK_Control_L);
    const State refused = viewer.wait_for("a message", [&](const State& s) {
        return message_has(s, file.string()) && message_has(s, "line 1");
    });
    CHECK(family_of(refused) == family_of(again));
}

TEST_CASE("a message about keys that do not match has a picture, and nothing remains once it is dismissed") {
    const RunningViewer viewer;
    const Picture plain = viewer.settled_picture();
    CHECK(count_red(plain) == 0);
    const State before = family_of(viewer.state());
    const fs::path family = fs::path(INTERLEAF_BAD_FILES) / "family-marking-differs";
    viewer.drop(std::vector{family}, view_middle(viewer.state()));
    const State state =
        viewer.wait_for("a message", [&](const State& s) { return message_has(s, family.string()); });
    CHECK(message_has(state, "refinement edge"));
    CHECK(count_red(viewer.changed_picture(plain)) > 100);
    CHECK(family_of(viewer.state()) == before);
    viewer.press(XK_Escape);
    CHECK(viewer.shows(plain));
    CHECK(viewer.state()["message"] == "");
}
