// Tests of the frames of a film.
#include "family/frame_times.h"

#include <limits>

#include "thrown_errors.h"
#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("frames begin and end with their range") {
    const FrameTimes frames = frames_in({1, 4}, 30);
    CHECK(frames.count == 91);
    CHECK(frames.at(0) == 1);
    CHECK(frames.at(90) == 4);
}

TEST_CASE("rounding takes no frame away: a tenth of a second at 30 frames per second has 4 frames") {
    CHECK(frames_in({0, 0.1}, 30).count == 4);
    CHECK(frames_in({0.7, 0.8}, 30).count == 4);
    CHECK(frames_in({0, 1}, 29.97).count == 30);
}

TEST_CASE("a loop shows the moment where it ends and begins once") {
    CHECK(frames_in({0, 2}, 25, true).count == 50);
    CHECK(frames_in({0, 2.01}, 25, true).count == 51);
    CHECK(frames_in({0, 0}, 25, true).count == 1);
}

TEST_CASE("a moment is one frame") {
    CHECK(frames_in({3, 3}, 24).count == 1);
}

TEST_CASE("frames without an end, a rate or a limit are refused") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(frames_in({2, 1}, 25), InputError);
    CHECK_THROWS_AS(frames_in({0, infinity}, 25), InputError);
    CHECK_THROWS_AS(frames_in({0, 1}, 0), InputError);
    CHECK_THROWS_AS(frames_in({0, 1}, -25), InputError);
    CHECK_THROWS_AS(frames_in({0, 1}, infinity), InputError);
    CHECK_THROWS_AS(frames_in({0, 1e9}, 60), InputError);
}
