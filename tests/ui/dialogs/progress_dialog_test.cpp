// Tests of the estimate of the remaining time.
#include "ui/dialogs/progress_dialog.h"

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("the remaining time appears once it can be estimated, in seconds or minutes") {
    CHECK(time_left(0, 10) == "");
    CHECK(time_left(0.5, 0.2) == "");
    CHECK(time_left(0.5, 4) == "about 4 s left");
    CHECK(time_left(0.25, 10) == "about 30 s left");
    CHECK(time_left(0.02, 10) == "about 9 min left");
    CHECK(time_left(1, 10) == "about 0 s left");
}
