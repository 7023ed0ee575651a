// Tests of the refine brush in the view, with the test as the mouse: what the brush takes, and what moves the camera.
#include "ui/panels/brush_bar.h"

#define GLFW_INCLUDE_NONE

#include <optional>

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>
#include <imgui.h>

#include "ui/headless_gui.h"
#include "ui/panels/view_area.h"

using namespace interleaf;

namespace {

constexpr Rect brushed_area{0, 0, 800, 600};

/// The view with the brush, frame by frame.
class BrushedView {
  public:
    BrushShown shown{.is_on = true,
                     .hint = "",
                     .is_over_surface = true,
                     .reads_keys = true,
                     .settings = {0.1F, 12, 8},
                     .min_radius = 0.01F,
                     .max_radius = 0.5F,
                     .deepest_level = 40};
    ViewInput input;
    BrushResult result;

    void frame(glm::vec2 pointer, bool is_down) {
        gui_.begin_frame(pointer, is_down);
        input = view_area(brushed_area);
        result = brush_bar(brushed_area, shown, result.hold, input);
        gui_.end_frame();
    }

    /// A frame with the pointer at rest, so that Dear ImGui knows the windows there.
    void rest(glm::vec2 pointer) {
        frame(pointer, false);
        frame(pointer, false);
    }

  private:
    HeadlessGui gui_{{800, 600}};
};

constexpr glm::vec2 stroke_begin{400, 300};
constexpr glm::vec2 stroke_end{460, 330};

}  // namespace

TEST_CASE("a drag that begins on the surface is a stroke, and moves no camera") {
    BrushedView brushed;
    brushed.rest(stroke_begin);
    CHECK_FALSE(brushed.result.hold);
    brushed.frame(stroke_begin, true);
    CHECK(brushed.result.begins);
    REQUIRE(brushed.result.hold);
    CHECK_FALSE(brushed.result.hold->coarsens);
    CHECK(brushed.result.from == stroke_begin);
    brushed.shown.is_over_surface = false;  // the stroke may leave the surface
    brushed.frame(stroke_end, true);
    CHECK_FALSE(brushed.result.begins);
    REQUIRE(brushed.result.hold);
    CHECK(brushed.result.from == stroke_begin);
    CHECK(brushed.result.hold->pointer == stroke_end);
    CHECK(brushed.input.orbit == glm::vec2(0));
    CHECK(brushed.input.pan == glm::vec2(0));
    brushed.frame(stroke_end, false);
    CHECK_FALSE(brushed.result.hold);
}

TEST_CASE("a drag beside the surface, with Ctrl, or without the brush orbits") {
    BrushedView brushed;
    SUBCASE("beside") {
        brushed.shown.is_over_surface = false;
    }
    SUBCASE("put away") {
        brushed.shown.is_on = false;
    }
    SUBCASE("without a key") {
        brushed.shown.hint = "Click a key";
    }
    SUBCASE("with Ctrl") {
        ImGui::GetIO().KeyCtrl = true;
    }
    brushed.rest(stroke_begin);
    brushed.frame(stroke_begin, true);
    CHECK_FALSE(brushed.result.hold);
    brushed.frame(stroke_end, true);
    CHECK_FALSE(brushed.result.hold);
    CHECK(brushed.input.orbit != glm::vec2(0));
}

TEST_CASE("Shift and Alt at the begin of a stroke coarsen, also when they are released before its end") {
    for (bool ImGuiIO::*const modifier : {&ImGuiIO::KeyShift, &ImGuiIO::KeyAlt}) {
        BrushedView brushed;
        ImGui::GetIO().*modifier = true;
        brushed.rest(stroke_begin);
        brushed.frame(stroke_begin, true);
        REQUIRE(brushed.result.hold);
        CHECK(brushed.result.hold->coarsens);
        ImGui::GetIO().*modifier = false;
        brushed.frame(stroke_end, true);
        REQUIRE(brushed.result.hold);
        CHECK(brushed.result.hold->coarsens);
        CHECK(brushed.input.pan == glm::vec2(0));
    }
}

TEST_CASE("the wheel changes the radius with a modifier, within its limits, and zooms without") {
    BrushedView brushed;
    brushed.rest(stroke_begin);
    ImGui::GetIO().MouseWheel = 1;
    brushed.frame(stroke_begin, false);
    CHECK_FALSE(brushed.result.settings);
    CHECK(brushed.input.zoom > 1);
    ImGui::GetIO().KeyAlt = true;
    ImGui::GetIO().MouseWheel = 1;
    brushed.frame(stroke_begin, false);
    REQUIRE(brushed.result.settings);
    CHECK(brushed.result.settings->radius > 0.1F);
    CHECK(brushed.input.zoom == 1);
    ImGui::GetIO().MouseWheel = -100;
    brushed.frame(stroke_begin, false);
    REQUIRE(brushed.result.settings);
    CHECK(brushed.result.settings->radius == 0.01F);
}

TEST_CASE("the bracket keys change the radius, and with Shift the level") {
    BrushedView brushed;
    brushed.rest(stroke_begin);
    ImGui::GetIO().KeysDown[GLFW_KEY_RIGHT_BRACKET] = true;
    brushed.frame(stroke_begin, false);
    REQUIRE(brushed.result.settings);
    CHECK(brushed.result.settings->radius == doctest::Approx(0.125));
    CHECK(brushed.result.settings->refined_level == 12);
    ImGui::GetIO().KeysDown[GLFW_KEY_RIGHT_BRACKET] = false;
    ImGui::GetIO().KeyShift = true;
    ImGui::GetIO().KeysDown[GLFW_KEY_LEFT_BRACKET] = true;
    brushed.frame(stroke_begin, false);
    REQUIRE(brushed.result.settings);
    CHECK(brushed.result.settings->radius == 0.1F);
    CHECK(brushed.result.settings->refined_level == 11);
}

TEST_CASE("the button takes the brush in hand, and no stroke begins under it") {
    BrushedView brushed;
    const glm::vec2 button{40, 28};
    brushed.shown.is_on = false;
    brushed.rest(button);
    brushed.frame(button, true);
    brushed.frame(button, false);
    CHECK(brushed.result.toggled);
    brushed.shown.is_on = true;
    brushed.rest(button);
    brushed.frame(button, true);
    CHECK_FALSE(brushed.result.begins);
}
