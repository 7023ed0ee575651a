// Tests of the brezel: its roots, its surface, and the keys made from them.
#include "shapes/brezel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "hierarchy/marking.h"
#include "hierarchy/measure.h"
#include "shapes/leaf_fit.h"
#include "shapes/leaf_triangles.h"
#include "shapes/shapes.h"

using namespace interleaf;

namespace {

Hierarchy make_brezel(const ShapeBudget& budget) {
    return make_key(*find_shape("brezel"), budget);
}

std::array<glm::dvec3, 3> corners_of(const Triangle& triangle, const Hierarchy& key) {
    return {key.positions[triangle[0]], key.positions[triangle[1]], key.positions[triangle[2]]};
}

/// The density by its definition, cube by cube.
double literal_density(const glm::dvec3& point) {
    constexpr std::array<std::string_view, 4> plate = {"######", "#.##.#", "#.##.#", "######"};
    const auto blurred = [](double p, double from) {
        return (std::erf((p - from) / 0.4) - std::erf((p - from - 1) / 0.4)) / 2;
    };
    double sum = 0;
    for (unsigned y = 0; y < 4; ++y) {
        for (unsigned x = 0; x < 6; ++x) {
            if (plate[y][x] == '#')
                sum += blurred(point.x, x - 3.0) * blurred(point.y, y - 2.0) * blurred(point.z, -0.5);
        }
    }
    return sum;
}

/// Distance from the surface, to first order; for points near it.
double distance_from_brezel(const glm::dvec3& point) {
    const auto [value, gradient] = brezel_density(point);
    return std::abs(value - brezel_level) / glm::length(gradient);
}

std::vector<glm::dvec3> random_points_around(unsigned seed, std::size_t count) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::vector<glm::dvec3> points;
    for (std::size_t i = 0; i < count; ++i) {
        points.emplace_back(3.5 * coordinate(random), 2.5 * coordinate(random), coordinate(random));
    }
    return points;
}

/// Largest distance of the surface from the key, sampled leaf by leaf. The sampling grid shares only corners
/// with the generator's grid.
double sampled_deviation(const Hierarchy& key) {
    double distance = 0;
    for (const Triangle& leaf : leaf_triangles(key)) {
        const std::array<glm::dvec3, 3> corners = corners_of(leaf, key);
        for (const glm::dvec3& point : base_grid(brezel, corners, 13)) {
            distance = std::max(distance, distance_to_triangle(point, corners));
        }
    }
    return distance;
}

}  // namespace

TEST_CASE("the plate is a sound key of 144 right isosceles triangles, of genus 2, facing out") {
    const Hierarchy plate = brezel_plate();
    CHECK(check(plate).empty());
    CHECK(plate.leaf_count() == 144);
    CHECK(plate.vertex_count() == 70);
    CHECK(is_closed_manifold(plate.roots.triangles()));
    CHECK(plate.roots.euler_number() == -2);
    const Measures measures = measure(plate.roots.triangles(), plate.positions);
    CHECK(measures.area == doctest::Approx(72));
    CHECK(measures.volume == doctest::Approx(20));
    CHECK(measures.min_angle == doctest::Approx(45));
}

TEST_CASE("the plate's refinement edges are the diagonals of its squares, for both triangles of each") {
    const Hierarchy plate = brezel_plate();
    CHECK(is_compatibly_marked(plate.roots));
    for (const Triangle& triangle : plate.roots.triangles()) {
        const auto [a, b, c] = corners_of(triangle, plate);
        CHECK(glm::distance(b, c) == doctest::Approx(std::sqrt(2.0)));
        CHECK(glm::distance(a, b) == 1);
        CHECK(glm::distance(a, c) == 1);
    }
}

TEST_CASE("the reflection at the center keeps the plate's triangles and their marking") {
    const Hierarchy plate = brezel_plate();
    const std::set<Triangle> triangles(plate.roots.triangles().begin(), plate.roots.triangles().end());
    const auto reflected = [&](Index vertex) {
        const auto place =
            std::find(plate.positions.begin(), plate.positions.end(), -plate.positions[vertex]);
        REQUIRE(place != plate.positions.end());
        return static_cast<Index>(place - plate.positions.begin());
    };
    for (const auto& [a, b, c] : triangles) {
        CHECK(triangles.count({reflected(a), reflected(c), reflected(b)}) == 1);
    }
}

TEST_CASE("each corner of the plate belongs to 4 to 8 triangles") {
    const Hierarchy plate = brezel_plate();
    std::vector<unsigned> triangles_at(plate.vertex_count());
    for (const Triangle& triangle : plate.roots.triangles())
        for (const Index vertex : triangle) ++triangles_at[vertex];
    CHECK(*std::min_element(triangles_at.begin(), triangles_at.end()) == 4);
    CHECK(*std::max_element(triangles_at.begin(), triangles_at.end()) == 8);
}

TEST_CASE("the density is the sum over the plate's blurred cubes, with its gradient") {
    const unsigned seed = 1;
    CAPTURE(seed);
    for (const glm::dvec3& point : random_points_around(seed, 2000)) {
        const auto [value, gradient] = brezel_density(point);
        CHECK(std::abs(value - literal_density(point)) < 1e-14);
        for (int axis = 0; axis < 3; ++axis) {
            constexpr double step = 1e-5;
            glm::dvec3 offset(0);
            offset[axis] = step;
            const double rise = literal_density(point + offset) - literal_density(point - offset);
            CHECK(std::abs(gradient[axis] - rise / (2 * step)) < 1e-8);
        }
    }
}

TEST_CASE("every point of the plate's boundary is projected onto the surface, and stays there") {
    const Hierarchy plate = brezel_plate();
    double farthest = 0;
    double moved = 0;
    for (const Triangle& triangle : plate.roots.triangles()) {
        for (const glm::dvec3& point : base_grid(brezel, corners_of(triangle, plate), 30)) {
            farthest = std::max(farthest, distance_from_brezel(point));
            moved = std::max(moved, glm::distance(point, project_to_brezel(point)));
        }
    }
    CHECK(farthest < 1e-14);
    CHECK(moved < 1e-14);
}

TEST_CASE(
    "every brezel key is sound, closed, of Euler number -2, faces out, and keeps its budget of leaves") {
    for (const Index budget : {144U, 145U, 146U, 1001U, 20000U}) {
        CAPTURE(budget);
        const Hierarchy key = make_brezel({budget, {}});
        CHECK(check(key).empty());
        CHECK(key.roots == brezel_plate().roots);
        const std::vector<Triangle> triangles = leaf_triangles(key);
        CHECK(is_closed_manifold(triangles));
        CHECK(euler_number(triangles) == -2);
        CHECK(measure(triangles, key.positions).volume > 13);
        CHECK(key.leaf_count() <= budget);
        CHECK(key.leaf_count() + 2 >= budget);
    }
}

TEST_CASE("all vertices are on the surface, to the precision of floats") {
    // Coordinates are below 4, so each is rounded by at most 1.2e-7.
    for (const glm::vec3& position : make_brezel({6000, {}}).positions) {
        CHECK(distance_from_brezel(position) < 2e-7);
    }
}

TEST_CASE("no leaf is flipped against the surface, and the minimum angle of 20,000 leaves is 23 degrees") {
    for (const Index budget : {144U, 1000U, 20000U}) {
        CAPTURE(budget);
        const Hierarchy key = make_brezel({budget, {}});
        const std::vector<Triangle> triangles = leaf_triangles(key);
        CHECK(measure(triangles, key.positions).min_angle > 23);
        const auto is_flipped = [&](const Triangle& leaf) {
            const auto [a, b, c] = corners_of(leaf, key);
            const glm::dvec3 inward = brezel_density(project_to_brezel((a + b + c) / 3.0)).gradient;
            return glm::dot(glm::cross(b - a, c - a), inward) >= 0;
        };
        CHECK(std::count_if(triangles.begin(), triangles.end(), is_flipped) == 0);
    }
}

TEST_CASE("a tolerance holds on dense samples of the brezel, without far too many leaves") {
    const double diagonal = bounding_box(make_brezel({20000, {}}).positions).diagonal();
    for (const double value : {0.02, 0.005, 0.001}) {
        CAPTURE(value);
        const Hierarchy key = make_brezel({{}, value});
        CHECK(check(key).empty());
        const double deviation = sampled_deviation(key) / diagonal;
        CHECK(deviation <= value);
        CHECK(deviation >= value / 4);
    }
    CHECK(make_brezel({{}, 0.1}).leaf_count() == 144);  // the roots are near enough
}

TEST_CASE("a brezel of more leaves is nearer to its surface") {
    CHECK(sampled_deviation(make_brezel({5000, {}})) < sampled_deviation(make_brezel({500, {}})) / 4);
}

TEST_CASE("fewer leaves than the brezel has roots are rejected") {
    CHECK_THROWS_WITH_AS(make_brezel({143, {}}), doctest::Contains("144 roots"), UsageError);
    CHECK_THROWS_WITH_AS(make_brezel({200, 0.1}), doctest::Contains("exclude each other"), UsageError);
}
