// Tests of the inspector: its texts, and what the mouse does in it.
#include "ui/panels/inspector_panel.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "ui/headless_gui.h"

using namespace interleaf;

namespace {

constexpr Rect inspected_area{0, 0, 800, 600};

InspectedNode node_without_parent() {
    InspectedNode node{.node = {}, .state = NodeState::bisected, .blend = {}, .keys = {}, .steps = {}};
    node.keys.push_back({"bone", {1, 0, 0}, NodeState::bisected, 3, 12, {}, {0, 1, no_index}});
    for (NodeStep step : all_node_steps)
        if (step != NodeStep::parent && step != NodeStep::sibling)
            node.steps.at(static_cast<std::size_t>(step)) = NodePath{1, 0, 0};
    return node;
}

const std::vector<std::string> shortcuts(all_node_steps.size(), "X");

/// Clicks at points of a grid over the panel.
/// \return the steps that the clicks asked for, and whether one closed the panel
std::pair<std::vector<NodeStep>, bool> click_everywhere(const InspectedNode& node) {
    HeadlessGui gui({800, 600});
    std::pair<std::vector<NodeStep>, bool> found;
    const auto frame = [&](glm::vec2 pointer, bool is_down) {
        gui.begin_frame(pointer, is_down);
        const InspectorResult result = inspector_panel(node, shortcuts, inspected_area);
        gui.begin_drawing();
        inspector_panel(node, shortcuts, inspected_area);
        gui.end_frame();
        return result;
    };
    for (int i = 0; i < 3; ++i) frame({0, 0}, false);
    for (float y = 16; y < 180; y += 8)
        for (float x = 16; x < 316; x += 12) {
            frame({x, y}, false);
            frame({x, y}, true);
            const InspectorResult result = frame({x, y}, false);
            if (result.step && std::ranges::find(found.first, *result.step) == found.first.end())
                found.first.push_back(*result.step);
            found.second |= result.is_over;
        }
    return found;
}

}  // namespace

TEST_CASE("a path has a digit per bisection, the first one first") {
    CHECK(path_text({5, 0, 0}) == "–");
    CHECK(path_text({5, 3, 0b110}) == "011");
    CHECK(path_text({5, 6, 0b100001}) == "1000 01");
    CHECK(path_text({0, 64, ~std::uint64_t{0}}).size() == 64 + 15);
}

TEST_CASE("coordinates in a root are exact fractions where these are short") {
    CHECK(dyadic_text(0) == "0");
    CHECK(dyadic_text(1) == "1");
    CHECK(dyadic_text(0.375) == "3/8");
    CHECK(dyadic_text(1 - 1.0 / 4096) == "4095/4096");
    CHECK(dyadic_text(1.0 / 8192) == "0.00012207");
}

TEST_CASE("the buttons of the inspector ask for every step that leads somewhere, and for no other") {
    const auto [steps, is_over] = click_everywhere(node_without_parent());
    CHECK(steps.size() == 5);
    CHECK(std::ranges::find(steps, NodeStep::parent) == steps.end());
    CHECK(std::ranges::find(steps, NodeStep::sibling) == steps.end());
    CHECK(is_over);
}

TEST_CASE("the inspector leaves its corner to a node that is there") {
    {
        const HeadlessGui gui({800, 600});
        CHECK(is_at_left({100, 0}, inspected_area));
        CHECK_FALSE(is_at_left({400, 0}, inspected_area));
    }
    CHECK_FALSE(click_everywhere(node_without_parent()).first.empty());
    InspectedNode at_left = node_without_parent();
    at_left.is_at_left = true;
    const auto [steps, is_over] = click_everywhere(at_left);
    CHECK(steps.empty());
    CHECK_FALSE(is_over);
}
