// Tests of the keys of commands in texts.
#include "ui/widgets/command_keys.h"

#include <doctest/doctest.h>

#include "ui/headless_gui.h"
#include "ui/widgets/gui_state.h"

using namespace interleaf;

TEST_CASE("texts name the keys that commands have now") {
    const HeadlessGui gui({640, 480});
    gui_state()->command_keys = {
        {"Play", "K or Space"}, {"Less detail", "-"}, {"More detail", "="}, {"Spin", ""}};
    CHECK(with_keys("Plays", {"Play"}) == "Plays (K or Space)");
    CHECK(with_keys("Detail", {"Less detail", "More detail"}) == "Detail (- and =)");
    CHECK(with_keys("Turns", {"Spin"}) == "Turns");
}

TEST_CASE("texts stay as they are where no keys are known") {
    const HeadlessGui gui({640, 480});
    CHECK(with_keys("Plays", {"Play"}) == "Plays");
}
