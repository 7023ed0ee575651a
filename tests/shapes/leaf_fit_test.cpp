#include "shapes/leaf_fit.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace interleaf;

TEST_CASE("the distance to a triangle is the distance to its plane, its edges or its corners") {
    const std::array<glm::dvec3, 3> corners = {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
    CHECK(distance_to_triangle({0.5, 0.5, -3}, corners) == doctest::Approx(3));
    CHECK(distance_to_triangle({0.5, 0.5, 0}, corners) == 0);
    CHECK(distance_to_triangle({1, -3, 4}, corners) == doctest::Approx(5));
    CHECK(distance_to_triangle({2, 2, 0}, corners) == doctest::Approx(std::sqrt(2.0)));
    CHECK(distance_to_triangle({-2, -1, 2}, corners) == doctest::Approx(3));
}

TEST_CASE("the distance to a triangle of no area is the distance to a segment or a point") {
    CHECK(distance_to_triangle({1, 1, 0}, {{{0, 0, 0}, {3, 0, 0}, {2, 0, 0}}}) == doctest::Approx(1));
    CHECK(distance_to_triangle({1, 2, 2}, {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}) == doctest::Approx(3));
}

TEST_CASE("the fit of a leaf over an octant has the distance at its centroid and the turn at its corners") {
    const LeafFit fit = measure_fit(unit_sphere, sphere_surface, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    // The samples next to the centroid lie at (2, 1, 1) / sqrt(6).
    CHECK(fit.distance == doctest::Approx(4 / std::sqrt(18.0) - 1 / std::sqrt(3.0)));
    CHECK(fit.apart >= fit.distance);
    CHECK(fit.apart == doctest::Approx(1 - std::sqrt(6.0) / 4));
    CHECK(fit.size == doctest::Approx(std::sqrt(2.0)));
    CHECK(fit.turn > 0.5);
    CHECK(fit.turn < 1);
}

TEST_CASE("a flat surface fits with distance 0 and turn 0") {
    const Surface octahedron = [](const glm::dvec3& u) {
        return u / (std::abs(u.x) + std::abs(u.y) + std::abs(u.z));
    };
    const LeafFit fit = measure_fit(unit_sphere, octahedron, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    CHECK(fit.distance < 1e-15);
    CHECK(fit.turn < 1e-12);
}

TEST_CASE("the grid of a spherical triangle lies on the sphere, corners included, row by row") {
    const auto grid = base_grid(unit_sphere, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 3);
    REQUIRE(grid.size() == 10);
    CHECK(grid[0] == glm::dvec3(1, 0, 0));
    CHECK(grid[6] == glm::dvec3(0, 1, 0));
    CHECK(grid[9] == glm::dvec3(0, 0, 1));
    CHECK(glm::distance(grid[4], glm::dvec3(1 / std::sqrt(3.0))) < 1e-15);
    for (const glm::dvec3& point : grid) CHECK(glm::length(point) == doctest::Approx(1).epsilon(1e-15));
}
