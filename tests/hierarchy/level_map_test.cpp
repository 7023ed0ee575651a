#include "hierarchy/level_map.h"

#include <doctest/doctest.h>
#include <glm/matrix.hpp>

#include "hierarchy/random_families.h"
#include "hierarchy/triangle.h"

using namespace interleaf;

TEST_CASE("each child's corners have the coordinates in the parent that bisection gives them") {
    // The parent is (i, j, k); l is the midpoint of (j, k).
    const glm::dvec3 i(1, 0, 0), j(0, 1, 0), k(0, 0, 1), l(0, 0.5, 0.5);
    const glm::dmat3 first = level_map(0, 1);
    CHECK(first[0] == l);
    CHECK(first[1] == k);
    CHECK(first[2] == i);
    const glm::dmat3 second = level_map(1, 1);
    CHECK(second[0] == l);
    CHECK(second[1] == i);
    CHECK(second[2] == j);
}

TEST_CASE("a composition agrees with placing the corners by bisection, and halves the area at each level") {
    testing::Random random(11);
    for (unsigned n = 0; n < 2000; ++n) {
        const auto level = static_cast<unsigned>(random.below(40));
        const std::uint64_t path = random.below(~std::size_t{0}) & ((std::uint64_t{1} << level) - 1);
        CAPTURE(path);
        std::vector<glm::dvec3> corners = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        Triangle triangle = {0, 1, 2};
        for (unsigned step = 0; step < level; ++step) {
            corners.push_back((corners[triangle[1]] + corners[triangle[2]]) / 2.0);
            triangle = bisect(triangle, static_cast<Index>(corners.size() - 1))[path >> step & 1];
        }
        const glm::dmat3 map = level_map(path, level);
        for (int c = 0; c < 3; ++c) REQUIRE(map[c] == corners[triangle[static_cast<std::size_t>(c)]]);
        // The determinant falls below 2^-40, which doubles still represent to a relative 1e-3.
        REQUIRE(glm::determinant(map) * static_cast<double>(std::uint64_t{1} << level) ==
                doctest::Approx(1).epsilon(1e-3));
    }
}
