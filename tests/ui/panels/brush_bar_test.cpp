// Tests of the refine brush in the view, with the test as the mouse: what the brush takes, and what moves the camera.
#include "ui/panels/brush_bar.h"

#include <optional>

#include <doctest/doctest.h>
#include <imgui.h>

#include "ui/headless_gui.h"
#include "ui/panels/view_area.h"

using namespace interleaf;

namespace {

constexpr Rect view{0, 0, 800, 600};

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
        input = view_area(view);
        result = brush_bar(view, shown, result.hold, input);
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

constexpr glm::vec2 here{400, 300};
constexpr glm::vec2 there{460, 330};

}  // namespace

TEST_CASE("a drag that begins on the surface is a stroke, and moves no camera") {
    BrushedView brushed;
    brushed.rest(here);
    CHECK_FALSE(brushed.result.hold);
    brushed.frame(here, true);
    CHECK(brushed.result.begins);
    REQUIRE(brushed.result.hold);
    CHECK_FALSE(brushed.result.hold->coarsens);
    CHECK(brushed.result.from == here);
    brushed.shown.is_over_surface = false;  // the stroke may leave the surface
    brushed.frame(there, true);
    CHECK_FALSE(brushed.result.begins);
    REQUIRE(brushed.result.hold);
    CHECK(brushed.result.from == here);
    CHECK(brushed.result.hold->pointer == there);
    CHECK(brushed.input.orbit == glm::vec2(0));
    CHECK(brushed.input.pan == glm::vec2(0));
    brushed.frame(there, false);
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
        ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, true);
    }
    brushed.rest(here);
    brushed.frame(here, true);
    CHECK_FALSE(brushed.result.hold);
    brushed.frame(there, true);
    CHECK_FALSE(brushed.result.hold);
    CHECK(brushed.input.orbit != glm::vec2(0));
}

TEST_CASE("Shift and Alt at the begin of a stroke coarsen, also when they are released before its end") {
    for (const ImGuiKey modifier : {ImGuiMod_Shift, ImGuiMod_Alt}) {
        BrushedView brushed;
        brushed.rest(here);
        ImGui::GetIO().AddKeyEvent(modifier, true);
        brushed.rest(here);
        brushed.frame(here, true);
        REQUIRE(brushed.result.hold);
        CHECK(brushed.result.hold->coarsens);
        ImGui::GetIO().AddKeyEvent(modifier, false);
        brushed.frame(there, true);
        REQUIRE(brushed.result.hold);
        CHECK(brushed.result.hold->coarsens);
        CHECK(brushed.input.pan == glm::vec2(0));
    }
}

TEST_CASE("the wheel changes the radius with a modifier, within its limits, and zooms without") {
    BrushedView brushed;
    brushed.rest(here);
    ImGui::GetIO().AddMouseWheelEvent(0, 1);
    brushed.frame(here, false);
    CHECK_FALSE(brushed.result.settings);
    CHECK(brushed.input.zoom > 1);
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Alt, true);
    ImGui::GetIO().AddMouseWheelEvent(0, 1);
    brushed.frame(here, false);
    REQUIRE(brushed.result.settings);
    CHECK(brushed.result.settings->radius > 0.1F);
    CHECK(brushed.input.zoom == 1);
    ImGui::GetIO().AddMouseWheelEvent(0, -100);
    brushed.frame(here, false);
    REQUIRE(brushed.result.settings);
    CHECK(brushed.result.settings->radius == 0.01F);
}

TEST_CASE("the bracket keys change the radius, and with Shift the level") {
    BrushedView brushed;
    brushed.rest(here);
    ImGui::GetIO().AddKeyEvent(ImGuiKey_RightBracket, true);
    brushed.frame(here, false);
    REQUIRE(brushed.result.settings);
    CHECK(brushed.result.settings->radius == doctest::Approx(0.125));
    CHECK(brushed.result.settings->refined_level == 12);
    ImGui::GetIO().AddKeyEvent(ImGuiKey_RightBracket, false);
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Shift, true);
    ImGui::GetIO().AddKeyEvent(ImGuiKey_LeftBracket, true);
    brushed.frame(here, false);
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
