// Tests of the layout: the panels cover any window, without gaps and overlaps.
#include "ui/layout.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

struct WindowSize {
    glm::vec2 size;
    float scale;
};

constexpr WindowSize window_sizes[] = {
    {{640, 480}, 1},   {{959, 700}, 1},      {{960, 700}, 1},   {{1280, 800}, 1},  {{1281, 801}, 1.25F},
    {{1920, 1080}, 1}, {{2560, 1440}, 1.5F}, {{3840, 2160}, 2}, {{3840, 2160}, 1}, {{480, 360}, 1}};

constexpr float menu_height = 24;

std::vector<Rect> parts(const Layout& layout) {
    std::vector<Rect> rects{layout.view, layout.right, layout.timeline, layout.status};
    if (layout.left) rects.push_back(*layout.left);
    return rects;
}

float overlap(float begin, float end, float other_begin, float other_end) {
    return std::max(std::min(end, other_end) - std::max(begin, other_begin), 0.0F);
}

}  // namespace

TEST_CASE("the panels cover the window below the menu bar exactly once") {
    for (const auto& [size, scale] : window_sizes) {
        CAPTURE(size.x);
        CAPTURE(scale);
        const auto rects = parts(lay_out(size, menu_height, scale, true));
        float area = 0;
        for (std::size_t i = 0; i < rects.size(); ++i) {
            const Rect& a = rects[i];
            CHECK(a.x >= 0);
            CHECK(a.y >= menu_height);
            CHECK(a.right() <= size.x);
            CHECK(a.bottom() <= size.y);
            area += a.width * a.height;
            for (std::size_t j = 0; j < i; ++j) {
                const Rect& b = rects[j];
                CHECK(overlap(a.x, a.right(), b.x, b.right()) * overlap(a.y, a.bottom(), b.y, b.bottom()) ==
                      0);
            }
        }
        CHECK(area == doctest::Approx(size.x * (size.y - menu_height)));
    }
}

TEST_CASE("edges lie on whole pixels, so that the picture is not resampled") {
    for (const auto& [size, scale] : window_sizes) {
        for (const Rect& rect : parts(lay_out(size, menu_height, scale, true))) {
            for (const float edge : {rect.x, rect.y, rect.width, rect.height})
                CHECK(edge == std::round(edge));
        }
    }
}

TEST_CASE("the view keeps the larger part of the width, even at 640 by 480") {
    for (const auto& [size, scale] : window_sizes) {
        CAPTURE(size.x);
        const Layout layout = lay_out(size, menu_height, scale, true);
        CHECK(layout.view.width >= 0.45F * size.x);
        CHECK(layout.view.height >= 0.5F * size.y);
    }
}

TEST_CASE("a narrow window has one column of panels, and a wide window has two") {
    CHECK_FALSE(lay_out({640, 480}, menu_height, 1, true).left);
    CHECK(lay_out({1280, 800}, menu_height, 1, true).left);
    CHECK_FALSE(lay_out({1280, 800}, menu_height, 2, true).left);
}

TEST_CASE("a window too small for any panel gives no negative size") {
    for (const Rect& rect : parts(lay_out({10, 10}, menu_height, 2, true))) {
        CHECK(rect.width >= 0);
        CHECK(rect.height >= 0);
    }
}

TEST_CASE("without a timeline, the view takes its place") {
    const Layout with = lay_out({1280, 800}, 24, 1, true);
    const Layout without = lay_out({1280, 800}, 24, 1, false);
    CHECK(without.timeline.height == 0);
    CHECK(without.view.height == with.view.height + with.timeline.height);
    CHECK(without.view.bottom() == without.status.y);
}

TEST_CASE("in a wide window the right column grows, and with it the parameter domain") {
    const float usual = lay_out({1280, 800}, menu_height, 1, true).right.width;
    CHECK(lay_out({1100, 800}, menu_height, 1, true).right.width == usual);
    const float wide = lay_out({1920, 1080}, menu_height, 1, true).right.width;
    CHECK(wide > 1.4F * usual);
    CHECK(lay_out({3840, 2160}, menu_height, 2, true).right.width == 2 * wide);
    CHECK(lay_out({3840, 2160}, menu_height, 1, true).right.width < 0.15F * 3840);
}
