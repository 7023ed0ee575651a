// Tests of the mouse over the surface: clicks, double-clicks and drags.
#include "ui/panels/view_area.h"

#include <doctest/doctest.h>

#include "ui/headless_gui.h"

using namespace interleaf;

namespace {

constexpr Rect area{100, 50, 800, 600};
constexpr glm::vec2 place{400, 300};

/// What a sequence of frames has told.
struct Told {
    int clicks = 0;
    int double_clicks = 0;
    glm::vec2 orbit{0};
};

class ViewHand {
  public:
    ViewHand() {
        for (int i = 0; i < 3; ++i) frame(place, false);
    }

    void frame(glm::vec2 pointer, bool is_down) {
        gui_.begin_frame(pointer, is_down);
        const ViewInput input = view_area(area);
        gui_.end_frame();
        told.clicks += input.clicked ? 1 : 0;
        told.double_clicks += input.view_all ? 1 : 0;
        told.orbit += input.orbit;
    }

    void click() {
        frame(place, true);
        frame(place, false);
    }

    Told told;

  private:
    HeadlessGui gui_{{1280, 800}};
};

}  // namespace

TEST_CASE("two clicks in one place are a double-click, and only its first is a click") {
    ViewHand hand;
    hand.click();
    CHECK(hand.told.clicks == 1);
    CHECK(hand.told.double_clicks == 0);
    hand.click();
    CHECK(hand.told.clicks == 1);
    CHECK(hand.told.double_clicks == 1);
}

TEST_CASE("a click and then a drag are no double-click") {
    ViewHand hand;
    hand.click();
    hand.frame(place, true);
    for (int step = 1; step <= 5; ++step) hand.frame(place + 20.0F * glm::vec2(step, 0), true);
    hand.frame(place + glm::vec2(100, 0), false);
    CHECK(hand.told.clicks == 1);
    CHECK(hand.told.double_clicks == 0);
    CHECK(hand.told.orbit.x > 0.1F);
}
