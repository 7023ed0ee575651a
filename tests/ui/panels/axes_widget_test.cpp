// Tests of the axes in the corner of the view.
#include "ui/panels/axes_widget.h"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "render/camera.h"
#include "ui/headless_gui.h"
#include "ui/panels/view_area.h"

using namespace interleaf;

namespace {

constexpr Rect view{100, 50, 800, 600};

AxesResult frame(HeadlessGui& gui, const Camera& camera, glm::vec2 pointer, bool is_down) {
    gui.begin_frame(pointer, is_down);
    const AxesResult result = axes_widget(view, camera.axes());
    const ViewInput input = view_area(view);
    CHECK(input.orbit == glm::vec2(0));  // the pointer over the axes is theirs
    gui.end_frame();
    return result;
}

glm::vec2 middle() {
    const Rect place = *axes_place(view);
    return {place.x + place.width / 2, place.y + place.height / 2};
}

/// Clicks on the end of the axis that points towards \p axis.
AxesResult click(const Camera& camera, glm::vec3 axis) {
    HeadlessGui gui({1280, 800});
    const glm::vec3 seen = glm::transpose(camera.axes()) * axis;
    const float arm = 30 * axes_place(view)->width / 84;
    const glm::vec2 at = middle() + arm * glm::vec2(seen.x, -seen.y);
    for (int i = 0; i < 3; ++i) frame(gui, camera, at, false);
    frame(gui, camera, at, true);
    return frame(gui, camera, at, false);
}

}  // namespace

TEST_CASE("a click on the end of an axis looks from there, and a second click from the other end") {
    Camera camera;
    camera.look_from(30, 20);
    for (const glm::vec3 axis : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0),
                                 glm::vec3(0, -1, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)}) {
        CAPTURE(axis.x);
        CAPTURE(axis.y);
        const AxesResult clicked = click(camera, axis);
        REQUIRE(clicked.look_from);
        Camera turned = camera;
        turned.look_from_end(*clicked.look_from);
        CHECK(glm::distance(turned.axes()[2], axis) < 1e-5F);
        const AxesResult again = click(turned, axis);
        REQUIRE(again.look_from);
        turned.look_from_end(*again.look_from);
        CHECK(glm::distance(turned.axes()[2], -axis) < 1e-5F);
    }
}

TEST_CASE("a drag over the axes turns and does not click") {
    Camera camera;
    HeadlessGui gui({1280, 800});
    const glm::vec2 at = middle();
    for (int i = 0; i < 3; ++i) frame(gui, camera, at, false);
    frame(gui, camera, at, true);
    glm::vec2 orbit(0);
    for (int step = 1; step <= 5; ++step)
        orbit += frame(gui, camera, at + 6.0F * glm::vec2(step, 0), true).orbit;
    CHECK(orbit.x > 0);
    CHECK(orbit.y == 0);
    CHECK_FALSE(frame(gui, camera, at + glm::vec2(30, 0), false).look_from);
}

TEST_CASE("a small view has no axes") {
    const HeadlessGui gui({1280, 800});
    CHECK(axes_place(view));
    CHECK_FALSE(axes_place({0, 0, 200, 600}));
    CHECK_FALSE(axes_place({0, 0, 600, 150}));
}
