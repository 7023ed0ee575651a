// Tests of the places of the window's parts.
#include "app/window/frame_layout.h"

#include <doctest/doctest.h>

#include "app/sample_family.h"

using namespace interleaf;

TEST_CASE("the active keys beside the blend share its part of the window, and give it back") {
    ViewerState state(sample_family());
    state.session.move_point({0.1, 0.5}, 0);
    REQUIRE(state.session.weights().size() == 3);
    for (const glm::vec2 window : {glm::vec2(1280, 800), glm::vec2(800, 500), glm::vec2(3840, 2160)}) {
        CAPTURE(window.x);
        state.shows_keys_beside = false;
        const FrameLayout whole = lay_out_frame(window, 24, 1, state);
        CHECK(whole.key_views.empty());
        state.shows_keys_beside = true;
        const FrameLayout divided = lay_out_frame(window, 24, 1, state);
        REQUIRE(divided.key_views.size() == 3);
        const Rect& view = divided.panels.view;
        float top = view.y;
        for (const Rect& place : divided.key_views) {
            CHECK(place.x == view.right());
            CHECK(place.right() == whole.panels.view.right());
            CHECK(place.y == top);
            CHECK(place.height > 60);
            // No narrower than the blend's picture, in proportion.
            CHECK(place.width / place.height >= 0.99F * view.width / view.height);
            top = place.bottom();
        }
        CHECK(top <= view.bottom());
        CHECK(view.width > divided.key_views.front().width);
    }
    CHECK(lay_out_frame({480, 360}, 24, 1, state).key_views.empty());
}
