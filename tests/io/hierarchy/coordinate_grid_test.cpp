#include "io/hierarchy/coordinate_grid.h"

#include <bit>
#include <limits>
#include <vector>

#include "trials.h"
#include <doctest/doctest.h>

#include "hierarchy/random_families.h"

namespace interleaf {

namespace {

using testing::Random;

constexpr float largest = std::numeric_limits<float>::max();
constexpr float smallest = std::numeric_limits<float>::denorm_min();

/// Points in a box anywhere, of any size that floats have room for.
std::vector<glm::vec3> points_anywhere(Random& random) {
    const float scale = std::ldexp(1.0F, static_cast<int>(random.below(220)) - 130);
    const glm::vec3 center = random.point() * (random.chance(0.5) ? 0.0F : 40.0F);
    std::vector<glm::vec3> points(2 + random.below(20));
    for (glm::vec3& point : points) point = scale * (center + random.point());
    return points;
}

double longest_side(std::span<const glm::vec3> points) {
    double longest = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const glm::vec3& a : points)
            for (const glm::vec3& b : points)
                longest = std::max(longest, std::abs(double{a[axis]} - double{b[axis]}));
    return longest;
}

}  // namespace

TEST_CASE("rounding moves no coordinate further than the stated bound") {
    for (std::uint64_t seed = 0; seed < trials(2000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const std::vector<glm::vec3> points = points_anywhere(random);
        const auto bits = static_cast<unsigned>(8 + random.below(17));
        CAPTURE(bits);
        const double bound = longest_side(points) / std::exp2(bits + 1);
        const Buffer<glm::vec3> rounded = rounded_positions(points, bits);
        REQUIRE(rounded.size() == points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                CHECK(std::abs(double{rounded[i][axis]} - double{points[i][axis]}) <= bound);
    }
}

TEST_CASE("what was rounded lies on a grid that gives its floats back, bit by bit") {
    for (std::uint64_t seed = 0; seed < trials(2000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const std::vector<glm::vec3> points = points_anywhere(random);
        const Buffer<glm::vec3> rounded =
            rounded_positions(points, static_cast<unsigned>(8 + random.below(9)));
        const std::optional<CoordinateGrid> grid = grid_of(rounded);
        REQUIRE(grid.has_value());
        for (const glm::vec3& point : rounded)
            for (int axis = 0; axis < 3; ++axis) {
                const float again = grid->coordinate(grid->number(point[axis]));
                CHECK(std::bit_cast<std::uint32_t>(again) == std::bit_cast<std::uint32_t>(point[axis]));
            }
    }
}

TEST_CASE("extreme coordinates stay finite when they are rounded") {
    for (const unsigned bits : {8U, 16U, 24U}) {
        const std::vector<glm::vec3> large = {{largest, -largest, 0}, {-largest, largest, 1}};
        for (const glm::vec3& point : rounded_positions(large, bits))
            for (int axis = 0; axis < 3; ++axis) CHECK(std::isfinite(point[axis]));
        const std::vector<glm::vec3> tiny = {{smallest, -smallest, 0}, {0, 3 * smallest, 0}};
        CHECK(rounded_positions(tiny, bits)[1] == tiny[1]);
        const std::vector<glm::vec3> one = {{0.1F, 0.2F, 0.3F}};
        CHECK(rounded_positions(one, bits)[0] == one[0]);
    }
}

TEST_CASE("a grid is found where there is one, and the coarsest") {
    const auto exponent_of = [](const std::vector<glm::vec3>& points) {
        const std::optional<CoordinateGrid> grid = grid_of(points);
        return grid ? std::optional(grid->exponent()) : std::nullopt;
    };
    CHECK(exponent_of({{1, 2, 3}}) == 0);
    CHECK(exponent_of({{0.75F, -2, 0}}) == -2);
    CHECK(exponent_of({{4096, -8192, 0}}) == 12);
    CHECK(exponent_of({{smallest, 0, 0}}) == -149);
    CHECK(exponent_of({{0.1F, 0.2F, 0.3F}}).has_value());
    CHECK_FALSE(exponent_of({{0.1F, 1000, 0}}).has_value());
    CHECK_FALSE(exponent_of({{1, -0.0F, 0}}).has_value());
}

TEST_CASE("a grid has a number for everything") {
    const CoordinateGrid grid(-3);
    CHECK(grid.number(0.25) == 2);
    CHECK(grid.number(-0.3) == -2);
    CHECK(grid.number(0.0625) == 1);
    CHECK(grid.number(-0.0625) == -1);
    for (const double beyond :
         {1e30, -1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        CHECK(grid.number(beyond) == 0);
}

}  // namespace interleaf
