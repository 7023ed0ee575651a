// The division of polygons into triangles: properties for every simple polygon, and rejected polygons.
#include "io/mesh/ear_clipping.h"

#include <cmath>
#include <ctime>
#include <numbers>
#include <random>
#include <string>

#include "sanitized.h"
#include "trials.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "io/polygons.h"

namespace interleaf {

namespace {

/// "" if the division is right; "refused" if there is none.
std::string fault_of(const Polygon& polygon, std::span<const glm::dvec3> corners, std::mt19937& random) {
    const std::vector<Triangle> triangles = divide_polygon(corners);
    return triangles.empty() ? "refused" : division_fault(polygon, triangles, 20, random);
}

/// Checks the polygon unchanged, started at another corner, reversed, and rotated in space.
void check_division(const Polygon& polygon, std::mt19937& random) {
    CAPTURE(polygon.size());
    CHECK(fault_of(polygon, in_space(polygon), random) == "");
    Polygon other = begun_at(polygon, random() % polygon.size());
    if (random() % 2 == 0) other = turned_over(other);
    CHECK(fault_of(other, in_random_plane(other, random), random) == "");
}

bool is_refused(const Polygon& polygon) {
    return divide_polygon(in_space(polygon)).empty();
}

}  // namespace

TEST_CASE("outlines are divided from every corner, in both orientations, in every plane") {
    constexpr unsigned seed = 1;
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (const auto& [name, polygon, area] : outlines()) {
        CAPTURE(name);
        CHECK(doubled_area(polygon) == 2 * area);
        for (std::size_t corner = 0; corner < polygon.size(); ++corner) {
            CAPTURE(corner);
            const Polygon begun = begun_at(polygon, corner);
            for (const Polygon& way : {begun, turned_over(begun)}) {
                CHECK(fault_of(way, in_space(way), random) == "");
                for (int plane = 0; plane < 10; ++plane)
                    CHECK(fault_of(way, in_random_plane(way, random), random) == "");
            }
        }
    }
}

TEST_CASE("random simple polygons are divided") {
    for (unsigned seed = 0; seed < trials(200); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        check_division(star_shaped(4 + random() % 200, random), random);
        check_division(uncrossed(4 + random() % 40, 0, random), random);
        check_division(grown(1 + random() % 60, random), random);
        check_division(comb(4 + random() % 100), random);
        check_division(spiral(6 + random() % 100), random);
        check_division(zigzag(6 + 2 * (random() % 100)), random);
    }
}

TEST_CASE("polygons that touch themselves at corners, along seams and along slits are divided") {
    int touching = 0;
    for (unsigned seed = 0; seed < trials(200); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        check_division(keyholes(1 + random() % 8), random);
        check_division(flower(3 + random() % 20), random);
        check_division(curtain(1 + random() % 20), random);
        const Polygon on_grid =
            uncrossed(4 + random() % 30, static_cast<unsigned>(6 + random() % 20), random);
        if (!do_edges_cross(on_grid)) check_division(on_grid, random);
        touching += !do_edges_cross(on_grid);
        check_division(maze(1 + random() % 8, 2 + random() % 40, random), random);
    }
    CHECK(touching > 10);
    // A hole with a seam from a corner, a hole that touches the outline, and a slit.
    std::mt19937 random(1);
    check_division({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}, random);
    check_division({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 4}, {4, 2}}, random);
    check_division({{0, 0}, {6, 0}, {6, 3}, {3, 3}, {6, 3}, {6, 6}, {0, 6}}, random);
}

TEST_CASE("collinear corners, repeated corners and edges without length leave no hole") {
    std::mt19937 random(1);
    check_division({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 3}, {1, 3}, {0, 3}}, random);
    check_division({{0, 0}, {1, 0}, {1, 0}, {2, 1}, {2, 1}, {0, 2}}, random);
    check_division({{0, 0}, {4, 0}, {4, 4}, {4, 4}, {2, 1}, {2, 1}, {0, 4}}, random);
    check_division({{0, 0}, {3, 0}, {1, 0}, {1, 1}}, random);
    for (const Polygon& line : {Polygon{{0, 0}, {1, 1}, {2, 2}, {3, 3}},
                                Polygon{{0, 0}, {2, 0}, {1, 0}, {3, 0}}, Polygon(5, {1, 1})}) {
        const std::vector<Triangle> triangles = divide_polygon(in_space(line));
        CHECK(triangles.size() == line.size() - 2);
    }
}

TEST_CASE("a polygon that crosses itself is rejected in any orientation") {
    const Polygon star_of_edges = [] {
        Polygon star;
        for (int i = 0; i < 5; ++i) {
            const double angle = 4 * std::numbers::pi * i / 5;
            star.emplace_back(std::cos(angle), std::sin(angle));
        }
        return star;
    }();
    const std::vector<Polygon> crossing{
        {{0, 0}, {1, 1}, {1, 0}, {0, 1}},
        {{0, 0}, {4, 4}, {4, 1}, {0, 3}},
        {{0, 0}, {4, 0}, {4, 4}, {2, -1}, {0, 4}},
        star_of_edges,
        {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 2}, {0, 2}},    // twice around
        {{0, 0}, {5, 0}, {5, 5}, {1, 5}, {1, -1}, {3, -1}, {3, 3}, {0, 3}},  // over itself
        {{4, 2}, {4, 0}, {2, 1}, {4, 2}, {4, 1}, {1, 1}},                    // at corners on edges
        {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}}};  // wrong hole
    std::mt19937 random(1);
    for (std::size_t number = 0; number < crossing.size(); ++number) {
        CAPTURE(number);
        for (std::size_t corner = 0; corner < crossing[number].size(); ++corner) {
            const Polygon begun = begun_at(crossing[number], corner);
            CHECK(is_refused(begun));
            CHECK(is_refused(turned_over(begun)));
            // Rotation may move a corner off its edge.
            if (number != 6) CHECK(divide_polygon(in_random_plane(begun, random)).empty());
        }
    }
}

TEST_CASE("random polygons are rejected exactly if their edges cross") {
    int refused = 0;
    int divided = 0;
    for (unsigned seed = 0; seed < trials(20'000); ++seed) {
        std::mt19937 random(seed);
        Polygon polygon(4 + random() % 6);
        for (glm::dvec2& corner : polygon) corner = {random() % 1'000'000, random() % 1'000'000};
        const bool is_crossing = do_edges_cross(polygon);
        const std::string fault = fault_of(polygon, in_space(polygon), random);
        (is_crossing ? refused : divided) += 1;
        if ((fault == "refused") == is_crossing && (is_crossing || fault.empty())) continue;
        CAPTURE(seed);
        CAPTURE(is_crossing);
        CHECK(fault == "");
    }
    CHECK(refused > 100);
    CHECK(divided > 100);
}

TEST_CASE("triangles never overlap, even on a small grid where corners lie on corners and edges") {
    int divided = 0;
    for (unsigned seed = 0; seed < trials(8000); ++seed) {
        std::mt19937 random(seed);
        Polygon polygon(4 + random() % 6);
        const auto steps = 3 + random() % 3;
        for (glm::dvec2& corner : polygon) corner = {random() % steps, random() % steps};
        const std::vector<Triangle> triangles = divide_polygon(in_space(polygon));
        if (triangles.empty() || doubled_area(polygon) == 0) continue;
        ++divided;
        const std::string fault = division_fault(polygon, triangles, 20, random);
        if (fault.empty()) continue;
        CAPTURE(seed);
        CHECK(fault == "");
    }
    CHECK(divided > 100);
}

TEST_CASE("a polygon that is not flat is divided in the plane that fits it best") {
    for (unsigned seed = 0; seed < trials(200); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> height(-0.3, 0.3);
        for (const auto& [name, polygon, area] : outlines()) {
            CAPTURE(name);
            std::vector<glm::dvec3> corners = in_space(polygon);
            for (glm::dvec3& corner : corners) corner.z = height(random);
            const std::vector<Triangle> triangles = divide_polygon(corners);
            REQUIRE(triangles.size() == polygon.size() - 2);
            double sum = 0;
            for (const auto& [a, b, c] : triangles) {
                const double part = doubled_area({polygon[a], polygon[b], polygon[c]}) / 2;
                CHECK(part > -0.7);  // the plane is slightly tilted
                sum += part;
            }
            CHECK(sum == doctest::Approx(area));
        }
    }
}

TEST_CASE("the size of a polygon and its distance from 0 do not matter") {
    std::mt19937 random(1);
    for (const double scale : {1e-300, 1e-30, 1e-6, 1e6, 1e30, 1e300})
        for (const auto& [name, polygon, area] : outlines()) {
            CAPTURE(name);
            CAPTURE(scale);
            std::vector<glm::dvec3> corners = in_space(polygon);
            for (glm::dvec3& corner : corners) corner *= scale;
            CHECK(fault_of(polygon, corners, random) == "");
            corners = in_space(polygon);
            for (glm::dvec3& corner : corners) corner += glm::dvec3(500'000, 5'400'000, 300);
            CHECK(fault_of(polygon, corners, random) == "");
        }
}

TEST_CASE("polygons with the largest number of corners take little time") {
    constexpr std::size_t most = is_sanitized ? 10'000 : max_polygon_corners;
    std::mt19937 random(1);
    const std::vector<std::pair<std::string, Polygon>> polygons{{"comb", comb(most)},
                                                                {"spiral", spiral(most)},
                                                                {"star", star_shaped(most, random)},
                                                                {"zigzag", zigzag(most)},
                                                                {"keyholes", keyholes(most / 7 - 1)},
                                                                {"flower", flower(most / 3)},
                                                                {"curtain", curtain(most / 3 - 1)},
                                                                {"maze", maze(223, most / 2 - 1, random)}};
    for (const auto& [name, polygon] : polygons) {
        CAPTURE(name);
        for (const bool is_rotated : {false, true}) {
            CAPTURE(is_rotated);
            const std::vector<glm::dvec3> corners =
                is_rotated ? in_random_plane(polygon, random) : in_space(polygon);
            REQUIRE(corners.size() <= most);
            const std::clock_t begin =
                std::clock();  // processor time, because a busy machine delays the clock
            const std::vector<Triangle> triangles = divide_polygon(corners);
            const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
            CHECK(seconds < 4);  // about 0.6 on an idle machine
            REQUIRE_FALSE(triangles.empty());
            CHECK(division_fault(polygon, triangles, 0, random) == "");
        }
    }
    Polygon crossed = star_shaped(most, random);
    std::swap(crossed[10], crossed[most / 2]);
    CHECK(is_refused(crossed));
}

TEST_CASE("a quadrilateral that is far from flat and crosses itself only in the plane is halved") {
    // From a public model: its opposite edges are far apart in space.
    const std::vector<glm::dvec3> skew{{12.880048, 236.295380, 43.735176},
                                       {12.819249, 236.278671, 43.792137},
                                       {12.944972, 236.356552, 42.972511},
                                       {12.883921, 236.197540, 42.910332}};
    CHECK(divide_polygon(skew).size() == 2);
    CHECK(divide_polygon(std::vector<glm::dvec3>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
}

}  // namespace interleaf
