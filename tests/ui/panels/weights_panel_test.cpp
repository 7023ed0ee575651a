// Tests of the weights panel: a mouse drags sliders, presses dots and buttons, and types numbers.
#include "ui/panels/weights_panel.h"

#include <doctest/doctest.h>
#include <fmt/core.h>
#include <imgui.h>

#include "render/palette.h"
#include "ui/headless_gui.h"
#include "ui/widgets/style.h"

using namespace interleaf;

namespace {

constexpr Rect panel_area{0, 0, 300, 700};

/// Rows of the panel at scale 1: heading, buttons of the drivers, then a row per key.
constexpr float first_row = 63;
constexpr float row_height = 20;
constexpr float dot_x = 18;

/// Shows the panel and applies what the mouse does.
class WeightsHand {
  public:
    explicit WeightsHand(std::size_t keys, Weights weights) : weights_(std::move(weights)) {
        for (std::size_t key = 0; key < keys; ++key) family_.keys.push_back({fmt::format("key {}", key), {}});
    }

    WeightsPanelResult frame(glm::vec2 pointer, bool is_down) {
        const DriverButton drivers[] = {{"Timeline", ""}, {"Weights", ""}};
        gui_.begin_frame(pointer, is_down);
        begin_panel("right", panel_area);
        WeightsPanelResult result = weights_panel(
            {.family = family_, .weights = weights_, .drivers = drivers, .driver = 0, .can_reset = true});
        end_panel();
        gui_.end_frame();
        if (result.weights) weights_ = *result.weights;
        return result;
    }

    void click(glm::vec2 at) {
        frame(at, false);
        frame(at, true);
        frame(at, false);
    }

    const Weights& weights() const { return weights_; }

    /// The place of the row of \p row in the slider, at \p part of it.
    static glm::vec2 slider(std::size_t row, float part) {
        constexpr float left = 146;
        constexpr float right = 288;
        return {left + part * (right - left), first_row + row_height * (static_cast<float>(row) + 0.4F)};
    }

    static glm::vec2 dot(std::size_t row) { return {dot_x, slider(row, 0).y}; }

  private:
    HeadlessGui gui_{{300, 700}};
    Family family_;
    Weights weights_;
};

}  // namespace

TEST_CASE("a dragged slider sets its weight from 0 to 1, however far the pointer goes") {
    WeightsHand hand(3, {{0, 1}, {1, 0.5}});
    hand.frame(WeightsHand::slider(1, 0.5F), false);
    hand.frame(WeightsHand::slider(1, 0.5F), true);
    hand.frame(WeightsHand::slider(1, 0.25F), true);
    CHECK(hand.weights()[1].value == doctest::Approx(0.25).epsilon(0.05));
    hand.frame(WeightsHand::slider(1, 3.0F), true);
    CHECK(hand.weights() == Weights{{0, 1}, {1, 1}});
    hand.frame(WeightsHand::slider(1, -3.0F), true);
    CHECK(hand.weights() == Weights{{0, 1}, {1, 0}});
}

TEST_CASE("a slider of a key that is not active makes the key active") {
    WeightsHand hand(3, {{0, 1}});
    hand.frame(WeightsHand::slider(2, 0.5F), false);
    hand.frame(WeightsHand::slider(2, 0.5F), true);
    REQUIRE(hand.weights().size() == 2);
    CHECK(hand.weights()[1].key == 2);
    CHECK(hand.weights()[1].value == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("a weight that nobody touches keeps all its digits") {
    WeightsHand hand(2, {{0, 1.0 / 3}, {1, -1e-9}});
    hand.click({150, 600});
    hand.click(WeightsHand::dot(3));
    CHECK(hand.weights() == Weights{{0, 1.0 / 3}, {1, -1e-9}});
}

TEST_CASE("dots take keys into the blend and out of it, but not the last one") {
    WeightsHand hand(3, {{0, 1}});
    hand.click(WeightsHand::dot(2));
    CHECK(hand.weights() == Weights{{0, 1}, {2, 0}});
    hand.click(WeightsHand::dot(0));
    CHECK(hand.weights() == Weights{{2, 0}});
    hand.click(WeightsHand::dot(2));
    CHECK(hand.weights() == Weights{{2, 0}});
}

TEST_CASE("a double click lets any number be typed") {
    WeightsHand hand(2, {{0, 1}, {1, 0.5}});
    const glm::vec2 at = WeightsHand::slider(1, 0.5F);
    hand.click(at);
    hand.frame(at, true);
    hand.frame(at, false);
    CHECK(ImGui::GetIO().WantTextInput);
    for (const char letter : std::string_view("-2.5"))
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(letter));
    hand.frame(at, false);
    CHECK(hand.weights() == Weights{{0, 1}, {1, -2.5}});
}

TEST_CASE("the buttons below make the sum 1, and ask for the first weights") {
    WeightsHand hand(2, {{0, 1}, {1, 3}});
    const float bottom = first_row + 2 * row_height + 8;
    hand.click({60, bottom});
    CHECK(hand.weights() == Weights{{0, 0.25}, {1, 0.75}});
    hand.frame({220, bottom}, true);
    CHECK(hand.frame({220, bottom}, false).resets);
}

TEST_CASE("a driver is chosen by its button") {
    WeightsHand hand(2, {{0, 1}});
    const glm::vec2 second{220, first_row - 14};
    hand.frame(second, false);
    hand.frame(second, true);
    CHECK(hand.frame(second, false).driver == 1u);
}

TEST_CASE("many keys have rows only while they are active") {
    WeightsHand hand(300, {{7, 1}, {250, 0}});
    hand.click(WeightsHand::dot(1));
    CHECK(hand.weights() == Weights{{7, 1}});
}
