// Tests of the edges between panels, with a hand at the mouse.
#include "ui/splitters.h"

#include <utility>

#include <doctest/doctest.h>
#include <imgui.h>

#include "ui/headless_gui.h"
#include "ui/widgets/style.h"

using namespace interleaf;

namespace {

constexpr glm::vec2 window_size{1280, 800};

/// A window whose panels follow the mouse.
class Hand {
  public:
    void at(glm::vec2 pointer, bool is_down) {
        gui_.begin_frame(pointer, is_down);
        show_panels();
        if (const auto changed = splitters(layout(), sizes_, 1)) sizes_ = *changed;
        gui_.begin_drawing();
        show_panels();
        splitters(layout(), sizes_, 1);
        gui_.end_frame();
    }

    void drag(glm::vec2 from, glm::vec2 to) {
        at(from, false);
        at(from, false);
        at(from, true);
        at((from + to) / 2.0F, true);
        at(to, true);
        at(to, false);
    }

    Layout layout() const { return lay_out(window_size, 24, 1, true, 0, sizes_); }
    const PanelSizes& sizes() const { return sizes_; }

  private:
    /// The edges must take the mouse from the panels that they overlap.
    void show_panels() const {
        const Layout now = layout();
        for (const auto& [name, rect] :
             {std::pair{"view", now.view}, std::pair{"left", *now.left}, std::pair{"right", now.right},
              std::pair{"timeline", now.timeline}}) {
            begin_panel(name, rect);
            ImGui::InvisibleButton("all", {rect.width, rect.height});
            end_panel();
        }
    }

    HeadlessGui gui_{window_size};
    PanelSizes sizes_;
};

}  // namespace

TEST_CASE("dragging the edge of a panel changes its size, and the surface takes the rest") {
    Hand hand;
    const Layout before = hand.layout();
    hand.drag({before.left->right(), 300}, {300, 310});
    CHECK(hand.layout().left->width == 300);
    CHECK(hand.layout().right == before.right);
    hand.drag({before.right.x, 300}, {900, 300});
    CHECK(hand.layout().right.width == 380);
    hand.drag({600, before.timeline.y}, {600, 500});
    CHECK(hand.layout().timeline.y == 500);
    CHECK(hand.layout().view.x == 300);
    CHECK(hand.layout().view.right() == 900);
    CHECK(hand.layout().view.bottom() == 500);
}

TEST_CASE("the surface keeps its part of the window, and a panel its least width") {
    Hand hand;
    hand.drag({hand.layout().left->right(), 300}, {1200, 300});
    CHECK(hand.layout().left->width < 0.4F * window_size.x);
    hand.drag({hand.layout().left->right(), 300}, {2, 300});
    CHECK(hand.layout().left->width >= 100);
    hand.drag({600, hand.layout().timeline.y}, {600, 30});
    CHECK(hand.layout().view.height >= 0.4F * window_size.y);
}

TEST_CASE("a double click on an edge gives the panel its usual size") {
    Hand hand;
    const float usual = hand.layout().left->width;
    hand.drag({usual, 300}, {300, 300});
    REQUIRE(hand.sizes().left.has_value());
    for (int frame = 0; frame < 60; ++frame)
        hand.at({300, 300}, false);  // no double click with the drag before
    for (const bool is_down : {true, false, true, false}) hand.at({300, 300}, is_down);
    CHECK_FALSE(hand.sizes().left.has_value());
    CHECK(hand.layout().left->width == usual);
}

TEST_CASE("the pointer beside an edge does not change it") {
    Hand hand;
    hand.drag({hand.layout().left->right() + 20, 300}, {500, 300});
    CHECK(hand.sizes() == PanelSizes{});
}
