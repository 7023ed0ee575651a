// Tests of the display panel below a list of five keys, in the usual left column of a window of 1280 x 800.
#include "ui/panels/display_panel.h"

#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/core.h>
#include <imgui.h>

#include "ui/headless_gui.h"
#include "ui/layout.h"
#include "ui/panels/keys_panel.h"
#include "ui/widgets/style.h"

using namespace interleaf;

namespace {

constexpr glm::vec2 window{1280, 800};
constexpr float bar_height = 23;

/// How far the column scrolls.
/// \param active  number of active keys; every set of them is an origin
float scroll_of(Coloring coloring, std::size_t active) {
    HeadlessGui gui(window);
    const Layout layout = lay_out(window, bar_height, 1, true, 0, {});
    std::vector<KeyRow> rows;
    for (int key = 0; key < 5; ++key) rows.push_back({fmt::format("key {}", key), 14'000, 12, 0});
    std::vector<std::size_t> keys;
    std::vector<std::string> names;
    for (std::size_t key = 0; key < active; ++key) {
        keys.push_back(key);
        names.push_back(fmt::format("key {}", key));
    }
    std::vector<KeySet> origins;
    for (KeySet set = 1; set < key_bit(active); ++set) origins.push_back(set);
    Display display;
    display.coloring = coloring;
    float scroll = 0;
    for (int frame = 0; frame < 4; ++frame) {
        gui.begin_frame({700, 300}, false);
        begin_panel("left", *layout.left);
        keys_panel({.keys = rows, .weights = {}, .selected = {}, .menu = {}, .search = {}},
                   0.5F * layout.view.height);
        section_gap();
        display_panel(display, {.levels = {0, 12},
                                .origins = origins,
                                .active_keys = keys,
                                .active_names = names,
                                .fields = {},
                                .key_without_field = {},
                                .measured = {.range = {0, 60}}});
        scroll = ImGui::GetScrollMaxY();
        end_panel();
        gui.end_frame();
    }
    return scroll;
}

}  // namespace

TEST_CASE("the legend of every coloring is seen without scrolling") {
    for (const Coloring coloring : colorings(false)) {
        CAPTURE(name_of(coloring));
        CHECK(scroll_of(coloring, 3) == 0);
    }
}

TEST_CASE("the legend of many origins shows as many as there is room for") {
    for (const std::size_t active : {4U, 5U}) {
        CAPTURE(active);
        CHECK(scroll_of(Coloring::origin, active) == 0);
    }
}

TEST_CASE("a locked range stays while the legend still shows that of the previous coloring") {
    HeadlessGui gui(window);
    const Layout layout = lay_out(window, bar_height, 1, true, 0, {});
    Display display;
    display.coloring = Coloring::angle;
    display.measured_range = {Coloring::angle, {10, 50}};
    for (const Coloring coloring : {Coloring::angle, Coloring::curvature, Coloring::angle}) {
        display.coloring = coloring;
        gui.begin_frame({700, 300}, false);
        begin_panel("left", *layout.left);
        display = display_panel(display, {.levels = {0, 12},
                                          .origins = {},
                                          .active_keys = {},
                                          .active_names = {},
                                          .fields = {},
                                          .key_without_field = {},
                                          .measured = {.range = {-3, 7}}})
                      .display;
        end_panel();
        gui.end_frame();
        REQUIRE(display.measured_range);
        CHECK(display.measured_range->coloring == Coloring::angle);
        CHECK(display.measured_range->range == ValueRange{10, 50});
    }
}
