// Tests of FrameFailures: which exceptions of frames the window outlives.
#include "app/window/frame_failures.h"

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("the window outlives an exception, and ends if the next frame has one again") {
    FrameFailures failures(true);
    failures.note_success();
    CHECK(failures.outlives_failure());
    CHECK_FALSE(failures.outlives_failure());
}

TEST_CASE("the window outlives every exception that follows a frame without one") {
    FrameFailures failures(true);
    for (int i = 0; i < 3; ++i) {
        CHECK(failures.outlives_failure());
        failures.note_success();
    }
    CHECK(failures.outlives_failure());
    CHECK_FALSE(failures.outlives_failure());
}

TEST_CASE("a window that only draws a picture ends with the first exception") {
    FrameFailures failures(false);
    failures.note_success();
    CHECK_FALSE(failures.outlives_failure());
}
