// The series that are refused, and what the user is told.
#include <limits>
#include <random>
#include <set>
#include <string>
#include <string_view>

#include <doctest/doctest.h>
#include <glm/common.hpp>

#include "hierarchy/error.h"
#include "sequence/series/generated_series.h"
#include "sequence/series/series.h"

namespace interleaf {
namespace {

using namespace interleaf::testing;

std::string refusal(const std::vector<FieldMesh>& steps, const SeriesOptions& options = {}) {
    try {
        recovered(steps, options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, std::string_view part) {
    const bool found = text.find(part) != std::string::npos;
    if (!found) MESSAGE(text);
    return found;
}

std::vector<FieldMesh> shuffled_steps(unsigned seed) {
    std::mt19937 random(seed);
    auto steps = random_steps(square_roots(3), 3, random);
    for (FieldMesh& step : steps) step = disguised(step, {0, true, true, false, 0}, random);
    return steps;
}

/// The unit square as two triangles, with the field "u".
FieldMesh two_triangles() {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
            {{1, 2, 0}, {3, 0, 2}},
            {0, 1},
            {{"u", 1, {0, 1, 2, 3}}},
            {}};
}

TEST_CASE("meshes that are not of one hierarchy are refused with the place and a tolerance to try") {
    auto steps = shuffled_steps(1);
    std::mt19937 random(4);
    steps.push_back(random_steps(square_roots(5), 1, random)[0]);
    const std::string text = refusal(steps);
    CHECK(contains(text, "step 3, triangle "));
    CHECK(contains(text, "neither contains nor is contained in triangles of earlier steps"));
    CHECK(contains(text, "--tolerance"));
}

TEST_CASE("surfaces that move without an order are refused, with what would help") {
    auto steps = shuffled_steps(2);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> moved(-1, 1);
    for (FieldMesh& step : steps)
        for (glm::dvec3& point : step.points) point.z = moved(random);
    const std::string text = refusal(steps);
    CHECK(contains(text, "step 1: vertices move and no order of corners marks the newest vertex"));
    CHECK(contains(text, "displacement"));
    SeriesOptions options;
    options.tolerance = 0.01;
    CHECK(contains(refusal(steps, options), "not in a plane"));
}

TEST_CASE("another domain is refused") {
    auto steps = shuffled_steps(3);
    for (glm::dvec3& point : steps[2].points) point.x *= 2;
    CHECK(contains(refusal(steps), "step 2: the mesh covers another domain than step 0"));
    SeriesOptions options;
    options.tolerance = 0.01;
    CHECK(contains(refusal(steps, options), "step 2: the mesh covers another domain than step 0"));
}

TEST_CASE("coordinates with too few digits are refused") {
    auto steps = shuffled_steps(3);
    for (glm::dvec3& point : steps[1].points) point = glm::round(point * 10.0) / 10.0;
    CHECK(contains(refusal(steps),
                   "step 1: coordinates have too few digits: corners of one triangle coincide"));
}

TEST_CASE("a hanging vertex is named") {
    FieldMesh mesh = two_triangles();
    mesh.points.emplace_back(0.5, 0.5, 0);
    mesh.point_fields[0].values.push_back(0);
    mesh.triangles = {{1, 2, 0}, {4, 2, 3}, {4, 3, 0}};
    CHECK(contains(refusal({mesh}), "step 0: hanging vertex at (0.5, 0.5, 0)"));
}

TEST_CASE("fields that are missing or not finite are named") {
    auto steps = shuffled_steps(3);
    steps[1].point_fields[0].name = "v";
    CHECK(contains(refusal(steps), "step 1: field u is missing"));
    SeriesOptions options;
    options.fields = {"w"};
    CHECK(contains(refusal(steps, options), "step 0: field w is missing; the point fields are: u"));
    steps = shuffled_steps(3);
    steps[2].point_fields[0].values[7] = std::numeric_limits<double>::quiet_NaN();
    CHECK(contains(refusal(steps), "step 2: field u is not finite at point 7"));
    for (FieldMesh& step : steps)
        step.point_fields.push_back({"v", 1, std::vector<double>(step.points.size(), 0)});
    options.fields = {"v"};
    CHECK(refusal(steps, options).empty());  // u is not asked for
}

TEST_CASE("surfaces that are no manifold, or cannot be oriented, are refused") {
    FieldMesh mesh = two_triangles();
    mesh.triangles.push_back({2, 0, 1});
    CHECK(contains(refusal({mesh}), "step 0: "));

    FieldMesh book = two_triangles();
    book.points.emplace_back(0, 0, 1);
    book.point_fields[0].values.push_back(0);
    book.triangles.push_back({4, 0, 2});
    CHECK(contains(refusal({book}), "3 triangles meet at the edge from (0, 0, 0) to (1, 1, 0)"));

    FieldMesh strip;  // a Moebius strip of five triangles
    for (int v = 0; v < 5; ++v) strip.points.emplace_back(v, v * v, v * v * v);
    for (Index v = 0; v < 5; ++v) strip.triangles.push_back({v, (v + 1) % 5, (v + 2) % 5});
    CHECK(contains(refusal({strip}), "cannot be oriented"));

    FieldMesh bow;  // two triangles with one common vertex
    bow.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    bow.triangles = {{0, 1, 2}, {0, 3, 4}};
    CHECK(contains(refusal({bow}), "no surface"));
}

TEST_CASE("indices, counts and options out of range are refused") {
    FieldMesh mesh = two_triangles();
    mesh.triangles[1][2] = 4;
    CHECK(contains(refusal({mesh}), "expected points below 4"));
    mesh = two_triangles();
    mesh.triangles[1][2] = 3;
    CHECK(contains(refusal({mesh}), "expected three different ones"));
    mesh = two_triangles();
    mesh.point_fields[0].values.pop_back();
    CHECK(contains(refusal({mesh}), "3 values for 4 points"));
    mesh = two_triangles();
    mesh.triangles.clear();
    CHECK(contains(refusal({mesh}), "no triangles"));
    CHECK(contains(refusal({}), "no steps"));
    SeriesOptions options;
    options.tolerance = 2;
    CHECK_THROWS_AS(recovered({two_triangles()}, options), UsageError);
    options.tolerance.reset();
    options.newest = 3;
    CHECK_THROWS_AS(recovered({two_triangles()}, options), UsageError);
}

TEST_CASE("welded points with different values get the mean, and the report says so") {
    FieldMesh mesh = two_triangles();
    mesh.points.insert(mesh.points.end(), {{0, 0, 0}, {1, 1, 0}});
    mesh.point_fields[0].values = {0, 1, 2, 3, 4, 2};
    mesh.triangles = {{1, 2, 0}, {3, 4, 5}};
    const Recovered result = recovered({mesh});
    REQUIRE(result.report.notes.size() == 1);
    CHECK(contains(result.report.notes[0], "step 0: field u has several values at 1 points"));
    const auto& values = result.keys[0].fields[0].values;
    CHECK(std::multiset<float>(values.begin(), values.end()) == std::multiset<float>{1, 2, 2, 3});
}

}  // namespace
}  // namespace interleaf
