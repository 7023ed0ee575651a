// Tests of the map between a parameter domain and its pixels.
#include "ui/widgets/plot_frame.h"

#include <random>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace interleaf;

namespace {

const std::vector<DomainVertex> square{{{-1, -1}, 0}, {{1, -1}, 1}, {{1, 1}, 2}, {{-1, 1}, 3}};
const std::vector<DomainVertex> wide{{{10, 2}, 0}, {{14, 2}, 1}, {{12, 3}, 2}};

}  // namespace

TEST_CASE("a box is fitted into the area, centered, with v up") {
    const PlotFrame frame(box_of(square), {100, 50, 200, 300});
    CHECK(frame.rect() == Rect{100, 100, 200, 200});
    CHECK(frame.pixel({-1, 1}) == glm::vec2(100, 100));
    CHECK(frame.pixel({1, -1}) == glm::vec2(300, 300));
    CHECK(frame.pixel({0, 0}) == glm::vec2(200, 200));
}

TEST_CASE("both axes have the same scale, so that shapes are not distorted") {
    const PlotFrame frame(box_of(wide), {0, 0, 200, 200});
    CHECK(frame.rect() == Rect{0, 75, 200, 50});
    CHECK(frame.pixel({12, 3}) == glm::vec2(100, 75));
}

TEST_CASE("the point of a pixel maps back to the pixel") {
    const unsigned seed = 1;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> coordinate(-50, 400);
    for (const auto& vertices : {square, wide}) {
        const PlotFrame frame(box_of(vertices), {13, 57, 211, 188});
        for (int i = 0; i < 100; ++i) {
            const glm::vec2 pixel(coordinate(random), coordinate(random));
            CHECK(glm::distance(frame.pixel(frame.point(pixel)), pixel) < 1e-3F);
        }
    }
}
