// End-to-end tests of the real window with a user before it. State and picture both change, or both stay, as
// they must.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "e2e/running_viewer.h"
#include "scratch_folder.h"
#include <X11/keysym.h>
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <unistd.h>

using namespace interleaf;
using State = RunningViewer::State;

namespace {

/// The pixel of a point of the five keys' domain, the square from -1 to 1.
glm::vec2 domain_pixel(const State& state, glm::vec2 point) {
    const State& r = state["rects"]["domain"];
    return {r[0].get<float>() + r[2].get<float>() * (point.x + 1) / 2,
            r[1].get<float>() + r[3].get<float>() * (1 - point.y) / 2};
}

/// The pixel of the shown point of the domain.
glm::vec2 point_pixel(const State& state) {
    return domain_pixel(state, {state["point"][0].get<float>(), state["point"][1].get<float>()});
}

/// The pixel at \p part of the timeline, 0 to 1.
glm::vec2 timeline_pixel(const State& state, float part) {
    const State& r = state["rects"]["timeline"];
    return {r[0].get<float>() + r[2].get<float>() * part, r[1].get<float>() + r[3].get<float>() / 2};
}

/// The pixel in the middle of the view, moved by \p offset.
glm::vec2 view_pixel(const State& state, glm::vec2 offset = {0, 0}) {
    const State& r = state["rects"]["view"];
    return glm::vec2(r[0].get<float>() + r[2].get<float>() / 2, r[1].get<float>() + r[3].get<float>() / 2) +
           offset;
}

double weight_sum(const State& state) {
    double sum = 0;
    for (const State& weight : state["weights"]) sum += weight.get<double>();
    return sum;
}

float eye_distance(const State& a, const State& b) {
    const auto eye = [](const State& s) {
        return glm::vec3(s["eye"][0].get<float>(), s["eye"][1].get<float>(), s["eye"][2].get<float>());
    };
    return glm::distance(eye(a), eye(b));
}

}  // namespace

TEST_CASE("the window opens on the five keys at time 0, with a shaded surface in the view") {
    const RunningViewer viewer;
    const State state = viewer.state();
    CHECK(state["time"] == 0);
    CHECK(state["playing"] == false);
    CHECK(state["driver"] == "timeline");
    CHECK(state["message"] == "");
    CHECK(state["rebuilds"] == 1);
    CHECK(weight_sum(state) == doctest::Approx(1));
    const Picture picture = viewer.settled_picture();
    CHECK(std::set<std::uint32_t>(picture.begin(), picture.end()).size() > 200);
}

TEST_CASE("the window fits onto the screen, also if it was larger on another one") {
    const ScratchFolder home;
    for (const bool was_larger : {false, true}) {
        CAPTURE(was_larger);
        if (was_larger) {
            std::filesystem::create_directory(home.path() / "interleaf");
            std::ofstream(home.path() / "interleaf" / "settings.json")
                << R"({"window": {"width": 3000, "height": 2000}})";
        }
        const RunningViewer viewer(home.path());
        const glm::ivec2 screen = viewer.desktop().screen_size();
        REQUIRE(screen.x < 1280);
        CHECK(viewer.state()["window"] == State({screen.x, screen.y}));
    }
}

TEST_CASE("dragging in the domain keeps the point under the pointer, and changes neither time nor camera") {
    const RunningViewer viewer;
    const State start =
        viewer.wait_for("a domain", [](const State& s) { return !s["rects"]["domain"].is_null(); });
    Picture picture = viewer.settled_picture();

    viewer.point_at(domain_pixel(start, {0.5F, 0}));
    viewer.set_button(1, true);
    for (const glm::vec2 point : {glm::vec2(0.5, 0), glm::vec2(0.4, 0.2), glm::vec2(0.8, -0.3),
                                  glm::vec2(0.1, 0.75), glm::vec2(-0.6, 0.1), glm::vec2(-0.2, -0.9)}) {
        CAPTURE(point.x);
        CAPTURE(point.y);
        const glm::vec2 pixel = glm::round(domain_pixel(start, point));
        viewer.point_at(pixel);
        const State state = viewer.wait_for("the point under the pointer", [&](const State& s) {
            return s["driver"] == "point" && glm::distance(point_pixel(s), pixel) <= 1;
        });
        CHECK(state["active"].size() == 3);
        CHECK(weight_sum(state) == doctest::Approx(1));
        CHECK(state["time"] == start["time"]);
        CHECK(state["eye"] == start["eye"]);
        picture = viewer.changed_picture(picture);
    }
    viewer.set_button(1, false);
    CHECK(viewer.state()["playing"] == false);
}

TEST_CASE("in every frame all panels show the state that the surface shows") {
    const RunningViewer viewer;
    const State start = viewer.state();
    viewer.point_at(domain_pixel(start, {0.5F, 0.1F}));
    viewer.set_button(1, true);
    for (const glm::vec2 point : {glm::vec2(0.1, 0.75), glm::vec2(-0.6, 0.1), glm::vec2(-0.2, -0.9)})
        viewer.point_at(domain_pixel(start, point));
    viewer.set_button(1, false);
    viewer.drag(timeline_pixel(start, 0.1F), timeline_pixel(start, 0.7F));
    viewer.press(XK_space);
    viewer.wait_for("time to run", [](const State& s) { return s["playing"] == true && s["time"] > 7.3; });
    viewer.press(XK_space);
    viewer.wait_for("a pause", [](const State& s) { return s["playing"] == false; });

    std::set<State> seen;
    for (const State& state : viewer.states()) {
        CAPTURE(state["frame"]);
        CHECK(state["panels"]["weights"] == state["weights"]);
        if (!state["late"].get<bool>()) CHECK(state["panels"]["legend"] == state["active"]);
        seen.insert(state["active"]);
    }
    CHECK(seen.size() >= 4);
}

TEST_CASE("within a triangle of the domain the union stays, and another triangle rebuilds it") {
    const RunningViewer viewer;
    const State start = viewer.state();
    const auto drag_to = [&](glm::vec2 point) {
        viewer.point_at(domain_pixel(start, point));
        viewer.state();
        return viewer.wait_for("the surface", [](const State& s) { return s["late"] == false; });
    };
    viewer.point_at(domain_pixel(start, {0.5F, 0.1F}));
    viewer.set_button(1, true);
    const State first = drag_to({0.5F, 0.1F});
    const State second = drag_to({0.8F, -0.2F});
    CHECK(second["rebuilds"] == first["rebuilds"]);
    CHECK(second["active"] == first["active"]);
    CHECK(second["weights"] != first["weights"]);
    const State third = drag_to({-0.5F, 0.1F});
    CHECK(third["rebuilds"] == first["rebuilds"].get<int>() + 1);
    CHECK(third["active"] != first["active"]);
    viewer.set_button(1, false);
}

TEST_CASE("after a click in the domain, arrow keys move the point; after Esc, they step through time again") {
    const RunningViewer viewer;
    const State start = viewer.state();
    viewer.click(domain_pixel(start, {0.25F, 0.5F}));
    const State placed = viewer.wait_for(
        "the point", [](const State& s) { return s["driver"] == "point" && s["domain_has_focus"]; });
    const auto u = [](const State& s) { return s["point"][0].get<double>(); };
    const auto v = [](const State& s) { return s["point"][1].get<double>(); };
    viewer.press(XK_Right);
    viewer.wait_for("a step to the right", [&](const State& s) {
        return std::abs(u(s) - u(placed) - 0.02) < 1e-6 && v(s) == v(placed);
    });
    viewer.press(XK_Down, XK_Shift_L);
    const State moved = viewer.wait_for(
        "a fine step down", [&](const State& s) { return std::abs(v(s) - v(placed) + 0.002) < 1e-6; });
    CHECK(moved["time"] == start["time"]);
    viewer.press(XK_Escape);
    viewer.wait_for("no focus", [](const State& s) { return s["domain_has_focus"] == false; });
    viewer.press(XK_Right);
    viewer.wait_for("a frame", [](const State& s) { return s["driver"] == "timeline" && s["time"] > 0; });
}

TEST_CASE("dragging out of the domain holds the point at the border") {
    const RunningViewer viewer;
    const State start = viewer.state();
    viewer.drag(domain_pixel(start, {0.2F, 0.1F}), domain_pixel(start, {0.25F, 1.6F}));
    const State state = viewer.state();
    CHECK(state["point"][1] == 1);
    CHECK(state["point"][0].get<double>() == doctest::Approx(0.25).epsilon(0.05));
}

TEST_CASE("scrubbing the timeline sets the time under the pointer, and returns the point to its path") {
    const RunningViewer viewer;
    const State start = viewer.state();
    Picture picture = viewer.settled_picture();
    viewer.drag(domain_pixel(start, {0.5F, 0}), domain_pixel(start, {0.7F, 0.3F}));
    CHECK(viewer.state()["driver"] == "point");
    picture = viewer.changed_picture(picture);

    viewer.point_at(timeline_pixel(start, 0.1F));
    viewer.set_button(1, true);
    const double seconds_a_pixel = 10 / start["rects"]["timeline"][2].get<double>();
    for (const float part : {0.1F, 0.33F, 0.71F, 0.55F}) {
        CAPTURE(part);
        viewer.point_at(timeline_pixel(start, part));
        const State state = viewer.state();
        CHECK(state["driver"] == "timeline");
        CHECK(std::abs(state["time"].get<double>() - 10 * part) <= seconds_a_pixel);
        CHECK(state["active"].size() == 2);
        CHECK(weight_sum(state) == doctest::Approx(1));
        CHECK(state["eye"] == start["eye"]);
        picture = viewer.changed_picture(picture);
    }
    viewer.point_at(timeline_pixel(start, 1.01F));
    CHECK(viewer.state()["time"] == 10);
    viewer.set_button(1, false);
}

TEST_CASE("Space starts and pauses: time runs, then stands still") {
    const RunningViewer viewer;
    const Picture before = viewer.settled_picture();
    viewer.press(XK_space);
    viewer.wait_for("playing", [](const State& s) { return s["playing"] == true; });
    viewer.wait_for("time to run", [](const State& s) { return s["time"] > 0.3; });
    viewer.press(XK_space);
    const State paused = viewer.wait_for("a pause", [](const State& s) { return s["playing"] == false; });
    viewer.changed_picture(before);
    CHECK(viewer.state()["time"] == paused["time"]);
}

TEST_CASE(
    "the timeline plays backward and slowly, zooms at the pointer, and its interpolation can be undone") {
    const RunningViewer viewer;
    const State start = viewer.state();
    viewer.press(XK_bracketleft);
    viewer.wait_for("half the speed", [](const State& s) { return s["speed"] == 0.5; });
    viewer.press(XK_space, XK_Shift_L);
    viewer.wait_for("time to run backward from the end", [](const State& s) {
        return s["playing"] == true && s["backward"] == true && s["time"] > 8;
    });
    viewer.press(XK_space, XK_Shift_L);
    viewer.wait_for("a pause", [](const State& s) { return s["playing"] == false; });

    viewer.press(XK_b);
    State state =
        viewer.wait_for("hold", [](const State& s) { return s["document"]["interpolation"] == "hold"; });
    CHECK(state["active"].size() == 1);
    viewer.press(XK_z, XK_Control_L);
    viewer.wait_for("linear again",
                    [](const State& s) { return s["document"]["interpolation"] == "linear"; });

    viewer.point_at(timeline_pixel(start, 0.25F));
    viewer.turn_wheel(true);
    state =
        viewer.wait_for("a part of the times", [](const State& s) { return !s["shown_times"].is_null(); });
    CHECK(state["shown_times"][0].get<double>() == doctest::Approx(0.5).epsilon(0.05));
    CHECK(state["shown_times"][1].get<double>() == doctest::Approx(8.5).epsilon(0.05));
    viewer.press(XK_Home, XK_Shift_L);
    viewer.wait_for("all times", [](const State& s) { return s["shown_times"].is_null(); });
}

TEST_CASE("a drag through the domain is recorded as a path that plays, and undo takes it back") {
    const RunningViewer viewer;
    const State start = viewer.state();
    viewer.press(XK_p);
    viewer.drag(domain_pixel(start, {0.5F, 0}), domain_pixel(start, {0.6F, -0.5F}));
    viewer.press(XK_p);
    const State recorded =
        viewer.wait_for("a path", [](const State& s) { return s["document"]["path"] >= 2; });
    CHECK(recorded["document"]["undo"] == "Record a path");
    CHECK(recorded["range"][1] < start["range"][1]);
    viewer.press(XK_space);
    viewer.wait_for("the path to play", [](const State& s) {
        return s["playing"] == true && s["driver"] == "timeline" && !s["point"].is_null();
    });
    viewer.press(XK_z, XK_Control_L);
    const State undone =
        viewer.wait_for("no path", [](const State& s) { return s["document"]["path"] == 0; });
    CHECK(undone["range"] == start["range"]);
}

TEST_CASE("less detail shows fewer leaves, and more detail the whole keys again") {
    const RunningViewer viewer;
    const State start = viewer.state();
    const auto change_detail = [&](KeyName key) {
        const auto before = viewer.state()["display"]["detail"].get<double>();
        viewer.press(key);
        return viewer.wait_for("another detail",
                               [&](const State& s) { return s["display"]["detail"] != before; });
    };
    constexpr int steps = 8;
    State state;
    for (int i = 0; i < steps; ++i) state = change_detail(XK_minus);
    CHECK(state["display"]["detail"].get<double>() == doctest::Approx(1 - 0.02 * steps));
    viewer.wait_for("fewer leaves", [&](const State& s) { return s["leaves"] < start["leaves"]; });
    for (int i = 0; i < steps; ++i) state = change_detail(XK_equal);
    CHECK(state["display"]["detail"] == 1);
    CHECK(state["leaves"] == start["leaves"]);
}

TEST_CASE("the detail follows the camera within its budget of leaves, until it is chosen again") {
    const RunningViewer viewer;
    // Bernstein polynomials blend all keys.
    for (const char* const basis : {"hold", "bernstein"}) {
        viewer.press(XK_b);
        viewer.wait_for(basis, [&](const State& s) { return s["document"]["interpolation"] == basis; });
    }
    viewer.drag(timeline_pixel(viewer.state(), 0.3F), timeline_pixel(viewer.state(), 0.5F));
    const State start =
        viewer.wait_for("five active keys", [](const State& s) { return s["active"].size() == 5; });
    REQUIRE(start["leaves"] > 20000);
    viewer.press(XK_c, XK_Shift_L);
    const State followed =
        viewer.wait_for("detail by camera", [](const State& s) { return s["detail_follows"] == true; });
    CHECK(followed["display"]["follows_camera"] == true);
    CHECK(followed["leaves"] <= 20000);
    CHECK(followed["leaves"] > 19000);
    viewer.drag(view_pixel(followed, {0, 0}), view_pixel(followed, {60, 30}));
    const State turned =
        viewer.wait_for("another eye", [&](const State& s) { return s["eye"] != start["eye"]; });
    CHECK(turned["detail_follows"] == true);
    CHECK(turned["leaves"] <= 20000);
    CHECK(turned["rebuilds"] == start["rebuilds"]);
    viewer.press(XK_c, XK_Shift_L);
    viewer.wait_for("whole keys", [&](const State& s) {
        return s["detail_follows"] == false && s["leaves"] == start["leaves"];
    });
}

TEST_CASE("dragging the point pauses playback, and Space continues from there") {
    const RunningViewer viewer;
    const State start = viewer.state();
    viewer.press(XK_space);
    viewer.wait_for("time to run", [](const State& s) { return s["time"] > 0.2; });
    viewer.drag(domain_pixel(start, {0.5F, 0}), domain_pixel(start, {0.6F, -0.2F}));
    const State dragged = viewer.state();
    CHECK(dragged["playing"] == false);
    CHECK(dragged["driver"] == "point");
    viewer.press(XK_space);
    const State state = viewer.wait_for("playing", [](const State& s) { return s["playing"] == true; });
    CHECK(state["driver"] == "timeline");
    CHECK(state["time"].get<double>() >= dragged["time"].get<double>());
}

TEST_CASE("each display key changes the picture, and changes it back") {
    struct Toggle {
        KeyName key;
        const char* name;
    };
    const RunningViewer viewer;
    // Two keys of different levels, so that each display key has a visible effect.
    viewer.drag(timeline_pixel(viewer.state(), 0.4F), timeline_pixel(viewer.state(), 0.47F));
    viewer.point_at(view_pixel(viewer.state()));
    const Picture plain = viewer.settled_picture();
    const State start = viewer.state();
    std::set<Picture> pictures{plain};
    for (const auto& [key, name] :
         {Toggle{XK_w, "wireframe"}, Toggle{XK_r, "refinement_edges"}, Toggle{XK_e, "root_edges"},
          Toggle{XK_v, "vertices"}, Toggle{XK_n, "normals"}, Toggle{XK_s, "shading"}}) {
        CAPTURE(name);
        viewer.press(key);
        const State on =
            viewer.wait_for(name, [&](const State& s) { return s["display"] != start["display"]; });
        CHECK(on["display"][name] != start["display"][name]);
        CHECK(on["rebuilds"] == start["rebuilds"]);
        CHECK(pictures.insert(viewer.changed_picture(plain)).second);
        viewer.press(key);
        viewer.wait_for("the display as before",
                        [&](const State& s) { return s["display"] == start["display"]; });
        CHECK(viewer.shows(plain));
    }
    for (const char* coloring : {"level", "origin", "common", "checker", "angle", "curvature", "moved"}) {
        viewer.press(XK_c);
        viewer.wait_for(coloring, [&](const State& s) { return s["display"]["coloring"] == coloring; });
        CHECK(pictures.insert(viewer.changed_picture(plain)).second);
    }
    viewer.press(XK_c);
    CHECK(viewer.shows(plain));
}

TEST_CASE(
    "a click inspects a leaf, keys step from it, and a double-click, a drag or Esc does not or ends it") {
    const RunningViewer viewer;
    const glm::vec2 middle = view_pixel(viewer.state());
    viewer.click(middle);
    const State leaf = viewer.wait_for("a leaf", [](const State& s) { return !s["inspected"].is_null(); });
    REQUIRE(leaf["inspected"][1] > 0);
    viewer.press(XK_Up, XK_Control_L, XK_Shift_L);
    viewer.wait_for("its parent", [&](const State& s) {
        return s["inspected"].is_array() && s["inspected"][1] == leaf["inspected"][1].get<int>() - 1;
    });
    // Not where the click was: soon after it, that would be a double-click.
    viewer.drag(middle + glm::vec2(80, 40), middle + glm::vec2(140, 70));
    CHECK(viewer.state()["inspected"][1] == leaf["inspected"][1].get<int>() - 1);
    viewer.press(XK_Escape);
    viewer.wait_for("nothing", [](const State& s) { return s["inspected"].is_null(); });
}

TEST_CASE("--along drives in that run alone, and is no edit") {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / fmt::format("interleaf-e2e-{}.family", getpid());
    std::filesystem::remove_all(folder);
    std::filesystem::copy(INTERLEAF_BUILTIN_FAMILY, folder, std::filesystem::copy_options::recursive);
    State family = State::parse(std::ifstream(folder / "family.json"));
    family["version"] = 2;
    family["domain"]["path"] = {{{"time", 0}, {"at", {-1, -1}}}, {{"time", 4}, {"at", {1, 1}}}};
    std::ofstream(folder / "family.json") << family;
    {
        const RunningViewer viewer({}, {folder, "--along", "keys"});
        CHECK(viewer.state()["document"]["changed"] == false);
        CHECK(viewer.state()["range"][1] == 10);
    }
    const RunningViewer viewer({}, {folder, "--along", "path"});
    const State state = viewer.state();
    CHECK(state["range"][1] == 4);
    CHECK(state["document"]["changed"] == false);
    CHECK(state["document"]["undo"].is_null());
    std::filesystem::remove_all(folder);
}

TEST_CASE("the colors of an OBJ are shown as a field, with the value under the pointer") {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / fmt::format("interleaf-e2e-{}.obj", getpid());
    std::ofstream(file) << "v 1 1 1 1 0 0\nv -1 -1 1 0 1 0\nv -1 1 -1 0 0 1\nv 1 -1 -1 1 1 1\n"
                           "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    const RunningViewer viewer({}, {file});
    const State start = viewer.state();
    CHECK(start["display"]["field"] == "color");
    viewer.point_at(view_pixel(start));
    std::set<Picture> pictures = {viewer.settled_picture()};
    for (const char* coloring :
         {"level", "origin", "common", "checker", "angle", "curvature", "moved", "field"}) {
        viewer.press(XK_c);
        viewer.wait_for(coloring, [&](const State& s) { return s["display"]["coloring"] == coloring; });
        pictures.insert(viewer.settled_picture());
    }
    // The value follows the pointer, and disappears with it.
    const Picture with_value = viewer.settled_picture();
    viewer.point_at(view_pixel(start, {20, 10}));
    const Picture beside = viewer.changed_picture(with_value);
    viewer.point_at({4, view_pixel(start).y});
    const Picture without = viewer.changed_picture(beside);
    CHECK(pictures.insert(without).second);
    viewer.point_at(view_pixel(start));
    CHECK(viewer.shows(with_value));
    std::filesystem::remove(file);
}

TEST_CASE("the mouse in the view moves only the camera, and F shows the whole model again") {
    const RunningViewer viewer;
    const State start = viewer.state();
    const Picture before = viewer.settled_picture();
    const auto nothing_else_changed = [&] {
        const State state = viewer.state();
        return state["weights"] == start["weights"] && state["time"] == start["time"] &&
               state["rebuilds"] == start["rebuilds"];
    };

    viewer.drag(view_pixel(start), view_pixel(start, {120, 40}));
    const State turned =
        viewer.wait_for("another view", [&](const State& s) { return s["eye"] != start["eye"]; });
    const Picture turned_picture = viewer.changed_picture(before);
    CHECK(nothing_else_changed());

    viewer.turn_wheel(true);
    const State nearer =
        viewer.wait_for("a nearer view", [&](const State& s) { return s["eye"] != turned["eye"]; });
    const Picture nearer_picture = viewer.changed_picture(turned_picture);
    CHECK(nothing_else_changed());

    viewer.press(XK_f);
    const State framed =
        viewer.wait_for("the model framed", [&](const State& s) { return s["eye"] != nearer["eye"]; });
    const Picture framed_picture = viewer.changed_picture(nearer_picture);

    viewer.drag(view_pixel(start), view_pixel(start, {-90, 60}), 3);
    const State shifted =
        viewer.wait_for("a shifted view", [&](const State& s) { return s["eye"] != framed["eye"]; });
    viewer.changed_picture(framed_picture);
    CHECK(eye_distance(shifted, framed) > 0.01F);
    CHECK(nothing_else_changed());

    viewer.press(XK_f);
    viewer.wait_for("the model framed as before",
                    [&](const State& s) { return eye_distance(s, framed) < 1e-4F; });
    CHECK(viewer.shows(framed_picture));
}

TEST_CASE("larger text moves the panels, which are drawn whole") {
    const RunningViewer viewer;
    viewer.point_at(view_pixel(viewer.state()));
    const Picture before = viewer.settled_picture();
    const State start = viewer.state();
    viewer.press(XK_equal, XK_Control_L);
    viewer.wait_for("wider panels", [&](const State& s) {
        return s["rects"]["keys"][2].get<float>() > start["rects"]["keys"][2].get<float>();
    });
    viewer.settled_picture();
    viewer.press(XK_minus, XK_Control_L);
    viewer.wait_for("the panels as before", [&](const State& s) { return s["rects"] == start["rects"]; });
    CHECK(viewer.shows(before));
}

TEST_CASE("the help covers the view until it is closed") {
    const RunningViewer viewer;
    const Picture before = viewer.settled_picture();
    viewer.press(XK_h);
    viewer.wait_for("the help", [](const State& s) { return s["help"] == true; });
    viewer.changed_picture(before);
    viewer.press(XK_Escape);
    viewer.wait_for("the help closed", [](const State& s) { return s["help"] == false; });
    CHECK(viewer.shows(before));
}

TEST_CASE("Ctrl+Q ends the program with status 0") {
    RunningViewer viewer;
    viewer.point_at(view_pixel(viewer.state()));
    viewer.press(XK_q, XK_Control_L);
    CHECK(viewer.exit_status() == 0);
}

TEST_CASE("view writes a picture of the window as the options ask, and closes") {
    const std::filesystem::path folder = std::filesystem::temp_directory_path();
    const auto picture_of = [&](const std::string& options) {
        const std::filesystem::path file = folder / fmt::format("interleaf-e2e-{}.png", getpid());
        const std::string command = fmt::format("'{}' view --size 900x600 --picture '{}' {}",
                                                INTERLEAF_PROGRAM, file.string(), options);
        REQUIRE(std::system(command.c_str()) == 0);
        std::ifstream stream(file, std::ios::binary);
        std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        std::filesystem::remove(file);
        // Signature, then the header chunk with width and height, big endian: 900 is 0x384, 600 is 0x258.
        REQUIRE(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
        CHECK(bytes.substr(16, 8) == std::string("\0\0\x03\x84\0\0\x02\x58", 8));
        return bytes;
    };
    const std::string first = picture_of("--at 0.3,0.4");
    CHECK(picture_of("--at 0.3,0.4 --show root-edges") != first);
    CHECK(picture_of("--at -0.3,0.4") != first);
    CHECK(picture_of("--time 3.5") != first);
}
