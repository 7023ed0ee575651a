// Tests of Redraw: when the window continues to draw, and when it rests.
#include "app/window/redraw.h"

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

/// Draws the frames that are due. None of them needs later frames.
/// \return the number of frames
int frames_until_rest(Redraw& redraw) {
    int frames = 0;
    while (redraw.is_due()) {
        redraw.begin_frame();
        redraw.follow({});
        ++frames;
    }
    return frames;
}

}  // namespace

TEST_CASE("a window draws until it has settled, then rests") {
    Redraw redraw;
    CHECK(frames_until_rest(redraw) == 3);
    redraw.follow({});
    CHECK_FALSE(redraw.is_due());
    redraw.settle();
    CHECK(frames_until_rest(redraw) == 3);
}

TEST_CASE("input, a change and playing each ask for as many frames as settling takes") {
    for (const FrameRest& rest :
         {FrameRest{.has_input = true}, FrameRest{.has_changed = true}, FrameRest{.moves = true}}) {
        Redraw redraw;
        frames_until_rest(redraw);
        redraw.follow(rest);
        CHECK(frames_until_rest(redraw) == 3);
    }
}

TEST_CASE("a picture that can be better and pictures of keys ask for one more frame each time") {
    for (const FrameRest& rest : {FrameRest{.is_coarse = true}, FrameRest{.lacks_portraits = true}}) {
        Redraw redraw;
        frames_until_rest(redraw);
        for (int frame = 0; frame < 5; ++frame) {
            redraw.follow(rest);
            CHECK(redraw.is_due());
            redraw.begin_frame();
        }
        CHECK_FALSE(redraw.is_due());
    }
}

TEST_CASE("a wish for one frame takes none of those that are due") {
    Redraw redraw;
    redraw.follow({.is_coarse = true});
    CHECK(frames_until_rest(redraw) == 3);
}
