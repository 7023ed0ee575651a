// Tests of the list of keys: its search, active keys, and clicks, among 300 keys.
#include "ui/panels/keys_panel.h"

#include <doctest/doctest.h>
#include <fmt/core.h>
#include <imgui.h>

#include "ui/headless_gui.h"
#include "ui/widgets/style.h"

using namespace interleaf;

namespace {

/// Shows the list, and is the mouse.
class ListHand {
  public:
    explicit ListHand(std::size_t count) {
        for (std::size_t key = 0; key < count; ++key) rows_.push_back({fmt::format("key {}", key), 20, 1, 0});
    }

    KeysPanelResult frame(glm::vec2 pointer, bool is_down) {
        gui_.begin_frame(pointer, is_down);
        begin_panel("left", {0, 0, 248, 700});
        KeysPanelResult result = keys_panel({.keys = rows_,
                                             .weights = weights,
                                             .selected = {},
                                             .menu = {},
                                             .search = search,
                                             .takes_focus = takes_focus},
                                            300);
        end_panel();
        gui_.end_frame();
        takes_focus = false;
        if (result.search) search = *result.search;
        return result;
    }

    /// Shows the list until what follows an input has settled.
    KeysPanelResult rest() {
        for (int i = 0; i < 3; ++i) frame({600, 600}, false);
        return frame({600, 600}, false);
    }

    KeysPanelResult click(glm::vec2 at) {
        frame(at, false);
        frame(at, true);
        return frame(at, false);
    }

    KeySearch search;
    Weights weights{{2, 0.5}, {250, 0.5}};
    bool takes_focus = false;

  private:
    HeadlessGui gui_{{1280, 800}};
    std::vector<KeyRow> rows_;
};

}  // namespace

TEST_CASE("a list of 300 keys shows some rows, and finds keys by their names") {
    ListHand hand(300);
    CHECK(hand.rest().visible.size() < 12);
    hand.search.text = "KEY 25";
    CHECK(hand.rest().visible.front() == 25);
    hand.search.text = "299";
    CHECK(hand.rest().visible == std::vector<std::size_t>{299});
    hand.search.text = "no such key";
    CHECK(hand.rest().visible.empty());
}

TEST_CASE("only active keys are shown where that is chosen, with the button too") {
    ListHand hand(300);
    hand.search.only_active = true;
    CHECK(hand.rest().visible == std::vector<std::size_t>{2, 250});
    hand.search.text = "250";
    CHECK(hand.rest().visible == std::vector<std::size_t>{250});
    hand.search = {};
    const float row = hand.rest().list.y - 18;
    hand.click({220, row});
    CHECK(hand.search.only_active);
    hand.click({220, row});
    CHECK_FALSE(hand.search.only_active);
}

TEST_CASE("a click chooses the key of its row in the search, and with Ctrl takes it into the blend") {
    ListHand hand(300);
    hand.search.text = "25";
    const Rect list = hand.rest().list;
    const glm::vec2 second{list.x + 100, list.y + 1.5F * (key_picture_side() + scaled(6))};
    CHECK(hand.click(second).chosen == 125u);
    ImGui::GetIO().KeyCtrl = true;
    const KeysPanelResult toggled = hand.click(second + glm::vec2(40, 0));  // no double click
    CHECK(toggled.toggled == 125u);
    CHECK_FALSE(toggled.chosen);
}

TEST_CASE("typing searches once the field has the keyboard") {
    ListHand hand(300);
    hand.takes_focus = true;
    hand.rest();
    for (const char letter : std::string_view("12"))
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(letter));
    CHECK(hand.rest().visible.front() == 12);
    CHECK(hand.search.text == "12");
}

TEST_CASE("a short list has a search only where it is wanted") {
    ListHand hand(5);
    hand.weights = {{3, 1}};
    hand.search.text = "3";
    CHECK(hand.rest().visible.size() == 5);
    hand.search.is_shown = true;
    CHECK(hand.rest().visible == std::vector<std::size_t>{3});
}

TEST_CASE("a search in a closed list opens it") {
    ListHand hand(20);
    CHECK_FALSE(hand.rest().visible.empty());
    GuiState& gui = *gui_state();
    gui.closed_sections.emplace("Keys");
    CHECK(hand.rest().visible.empty());
    hand.search.is_shown = true;
    hand.takes_focus = true;
    CHECK_FALSE(hand.rest().visible.empty());
    CHECK(gui.closed_sections.empty());
}
