// The distance from a mesh is that of the slow search through all triangles, however long the triangles are.
#include "fit/mesh/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace interleaf;

TEST_CASE("distances from needles and triangles without area are those of a search through all of them") {
    for (const unsigned seed : {1U, 2U, 3U}) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> place(-1, 1);
        const auto somewhere = [&] { return glm::dvec3(place(random), place(random), place(random)); };
        std::vector<glm::dvec3> positions;
        std::vector<Triangle> triangles;
        for (Index i = 0; i < 300; ++i) {
            // Every third triangle is a needle, and some of the others have no area.
            const glm::dvec3 corner = somewhere();
            const glm::dvec3 side = (i % 3 == 0 ? 2.0 : 0.05) * somewhere();
            const double width = i % 3 == 0 ? 1e-3 : i % 7 == 0 ? 0.0 : 0.05;
            for (const glm::dvec3& position :
                 {corner, corner + side, corner + 0.4 * side + width * somewhere()})
                positions.push_back(position);
            triangles.push_back({3 * i + i % 2, 3 * i + 1 - i % 2, 3 * i + 2});
        }
        const SurfaceDistance distance(triangles, positions);
        Index nearest = no_index;
        for (int trial = 0; trial < 500; ++trial) {
            const glm::dvec3 point = 1.5 * somewhere();
            double least = std::numeric_limits<double>::infinity();
            for (const auto& [a, b, c] : triangles)
                least = std::min(
                    least, squared_distance_to_triangle(point, {positions[a], positions[b], positions[c]}));
            CHECK(distance(point, nearest) == doctest::Approx(std::sqrt(least)).epsilon(1e-12));
            Index near = 0;
            CHECK(distance.is_within(point, 1.001 * std::sqrt(least), near));
            const auto& [a, b, c] = triangles[near];
            CHECK(squared_distance_to_triangle(point, {positions[a], positions[b], positions[c]}) <=
                  1.003 * least);
            CHECK_FALSE(distance.is_within(point, 0.999 * std::sqrt(least), near));
        }
    }
}

TEST_CASE("the two chains of a long triangle have its corners, and its width between them") {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-1, 1);
    for (int trial = 0; trial < 100; ++trial) {
        CAPTURE(trial);
        TriangleCorners corners;
        for (glm::dvec3& corner : corners) corner = {place(random), place(random), place(random)};
        const LongTriangle along(corners);
        CHECK(along.on_other_sides(0) == along.on_side(0));
        CHECK(glm::distance(along.on_other_sides(1), along.on_side(1)) < 1e-12);
        CHECK(glm::distance(along.on_other_sides(along.apex_part()), along.apex()) < 1e-12);
        // The triangle is half as large as the rectangle over its longest side.
        double width = 0;
        constexpr int strips = 1000;
        for (int strip = 0; strip < strips; ++strip) {
            const double part = (strip + 0.5) / strips;
            width += glm::distance(along.on_side(part), along.on_other_sides(part)) / strips;
        }
        CHECK(2 * width * along.length() == doctest::Approx(doubled_area(corners)).epsilon(1e-3));
    }
}
