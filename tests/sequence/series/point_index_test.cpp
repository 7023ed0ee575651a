#include "sequence/series/point_index.h"

#include <algorithm>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "sequence/series/generated_series.h"
#include "sequence/series/triangle_index.h"

namespace interleaf {
namespace {

using namespace interleaf::testing;

TEST_CASE("a point is found within the tolerance, and only there, as by looking at all points") {
    for_each_trial(20, [](std::mt19937& random) {
        std::uniform_real_distribution<double> anywhere(-1, 1);
        const auto point = [&] { return glm::dvec3(anywhere(random), anywhere(random), 0); };
        const double tolerance = 0.01;
        std::vector<glm::dvec3> points;
        while (points.size() < 100) {
            const glm::dvec3 next = point();
            const bool is_far = std::ranges::all_of(
                points, [&](const glm::dvec3& other) { return glm::distance(next, other) > 2 * tolerance; });
            if (is_far) points.push_back(next);
        }
        PointIndex index(points, tolerance);
        for (Index p = 0; p < points.size(); ++p) index.add(p);
        for (int query = 0; query < 2000; ++query) {
            const glm::dvec3 at = query % 2 == 0 ? point() : points[random() % 100] + 0.012 * point();
            const auto near = std::ranges::find_if(
                points, [&](const glm::dvec3& other) { return glm::distance(at, other) <= tolerance; });
            const Index expected =
                near == points.end() ? no_index : static_cast<Index>(near - points.begin());
            CHECK(index.find(at) == expected);
        }
        CHECK(index.find({1e300, 0, 0}) == no_index);
    });
}

TEST_CASE("without a tolerance, points with equal coordinates are found") {
    const std::vector<glm::dvec3> points = {{0, 0, 0}, {1, 0, 0}, {1e-9, 0, 0}, {0, 1e6, 0}};
    PointIndex index(points, 0);
    for (Index p = 0; p < points.size(); ++p) index.add(p);
    for (Index p = 0; p < points.size(); ++p) CHECK(index.find(points[p]) == p);
    CHECK(index.find({-0.0, 0, 0}) == 0);
    CHECK(index.find({0.5, 0, 0}) == no_index);
}

TEST_CASE("a triangle is found by its corners in any order") {
    const std::vector<Triangle> triangles = {{0, 1, 2}, {2, 1, 3}, {4, 7, 5}};
    TriangleIndex index(triangles);
    for (Index t = 0; t < triangles.size(); ++t) index.add(t);
    CHECK(index.find({2, 0, 1}) == 0);
    CHECK(index.find({3, 1, 2}) == 1);
    CHECK(index.find({5, 7, 4}) == 2);
    CHECK(index.find({0, 1, 3}) == no_index);
}

}  // namespace
}  // namespace interleaf
