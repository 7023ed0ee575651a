#include "sequence/surface_stretch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

namespace interleaf {
namespace {

using Corners = std::array<glm::dvec3, 3>;

TEST_CASE("the stretch is the largest growth of a length, over many directions in the triangle") {
    constexpr unsigned seed = 21;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto point = [&] {
        const double x = uniform(random);
        const double y = uniform(random);
        return glm::dvec3(x, y, uniform(random));
    };
    for (int trial = 0; trial < 50; ++trial) {
        const Corners before = {point(), point(), point()};
        const Corners now = {point(), point(), point()};
        double largest = 0;
        const glm::dvec3 u = glm::normalize(before[1] - before[0]);
        const glm::dvec3 other = before[2] - before[0];
        const glm::dvec3 v = glm::normalize(other - glm::dot(other, u) * u);
        const double height = glm::dot(other, v);
        for (int i = 0; i < 2000; ++i) {
            // The direction cos u + sin v as a combination of both sides.
            const double angle = std::numbers::pi * i / 2000;
            const double second = std::sin(angle) / height;
            const double first =
                (std::cos(angle) - second * glm::dot(other, u)) / glm::distance(before[1], before[0]);
            largest = std::max(largest, glm::length(first * (now[1] - now[0]) + second * (now[2] - now[0])));
        }
        CHECK(stretch_of(before, now) == doctest::Approx(largest).epsilon(1e-4));
    }
}

TEST_CASE("a triangle that is moved and turned has stretch 1, a triangle without area 0") {
    const Corners before = {glm::dvec3(0, 0, 0), glm::dvec3(2, 0, 0), glm::dvec3(1, 3, 0)};
    const Corners turned = {glm::dvec3(5, 0, 1), glm::dvec3(5, 2, 1), glm::dvec3(5, 1, 4)};
    CHECK(stretch_of(before, turned) == doctest::Approx(1));
    const Corners line = {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(2, 0, 0)};
    CHECK(stretch_of(line, turned) == 0);
    CHECK(stretch_of(Corners{}, turned) == 0);
}

TEST_CASE("a vertex has the mean stretch of its triangles, weighted by the areas before") {
    const std::vector<glm::dvec3> before = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -3, 0}, {9, 9, 9}};
    const std::vector<glm::dvec3> now = {{0, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, -3, 0}, {9, 9, 9}};
    const std::vector<float> stretches =
        vertex_stretches(std::vector<Triangle>{{0, 1, 2}, {1, 0, 3}}, before, now);
    CHECK(stretches[2] == doctest::Approx(3));
    CHECK(stretches[3] == doctest::Approx(1));
    CHECK(stretches[0] == doctest::Approx((1 * 3 + 3 * 1) / 4.0));
    CHECK(stretches[4] == 0);
}

}  // namespace
}  // namespace interleaf
