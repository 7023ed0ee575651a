// The exact recovery: by order and by place.
#include <algorithm>
#include <random>

#include <doctest/doctest.h>

#include "hierarchy/checker.h"
#include "sequence/series/generated_series.h"
#include "sequence/series/series.h"

namespace interleaf {
namespace {

using namespace interleaf::testing;

void check_keys(const Recovered& result, const std::vector<FieldMesh>& steps) {
    REQUIRE(result.keys.size() == steps.size());
    REQUIRE(result.report.steps.size() == steps.size());
    for (std::size_t step = 0; step < steps.size(); ++step) {
        CAPTURE(step);
        const Hierarchy& key = result.keys[step];
        CHECK(check(key).empty());
        CHECK(key.roots == result.keys[0].roots);
        CHECK(key.leaf_count() == steps[step].triangles.size());
        CHECK(corner_sets(key) == corner_sets(steps[step]));
        CHECK(result.report.steps[step].leaves == key.leaf_count());
        CHECK(result.report.steps[step].triangles == steps[step].triangles.size());
    }
}

std::vector<FieldMesh> disguised_steps(const std::vector<FieldMesh>& steps, const Disguise& disguise,
                                       std::mt19937& random) {
    std::vector<FieldMesh> result;
    for (const FieldMesh& step : steps) result.push_back(disguised(step, disguise, random));
    return result;
}

TEST_CASE("the leaves of keys are the triangles of the steps, whichever corner is the newest vertex") {
    for_each_trial(10, [](std::mt19937& random) {
        const auto steps = random_steps(square_roots(4), 3, random);
        for (const unsigned newest : {0U, 1U, 2U}) {
            CAPTURE(newest);
            for (const bool turned_over : {false, true}) {
                Disguise disguise;
                disguise.newest = newest;
                disguise.turned_over = turned_over;
                const auto files = disguised_steps(steps, disguise, random);
                const Recovered result = recovered(files);
                check_keys(result, files);
                CHECK(result.report.method == SeriesMethod::by_order);
            }
        }
    });
}

TEST_CASE("the order of corners recovers a surface whose vertices all move") {
    for_each_trial(10, [](std::mt19937& random) {
        auto steps = random_steps(square_roots(4), 3, random);
        std::uniform_real_distribution<double> moved(-1, 1);
        for (FieldMesh& step : steps)
            for (glm::dvec3& point : step.points) point.z = moved(random);
        const Recovered result = recovered(steps);
        check_keys(result, steps);
        CHECK(result.report.method == SeriesMethod::by_order);
        CHECK(result.report.root_count <= 32);
    });
}

TEST_CASE("the places of vertices recover what is shuffled, turned over, doubled and moved a little") {
    for_each_trial(10, [](std::mt19937& random) {
        const auto steps = random_steps(square_roots(3), 4, random);
        const double noise = 0.01 * shortest_edge(steps);
        for (const Disguise& disguise :
             {Disguise{0, false, true, false, 0}, Disguise{0, true, true, false, 0},
              Disguise{0, true, true, true, 0}, Disguise{0, true, true, true, noise}}) {
            const auto files = disguised_steps(steps, disguise, random);
            const Recovered result = recovered(files);
            check_keys(result, files);
            CHECK(result.report.method == SeriesMethod::by_place);
        }
    });
}

TEST_CASE("the recovery by place does not depend on the order of triangles but for the order of roots") {
    std::mt19937 random(7);
    const auto steps = random_steps(square_roots(3), 4, random);
    const Disguise shuffled{0, true, true, false, 0};
    const Recovered first = recovered(disguised_steps(steps, shuffled, random));
    const Recovered second = recovered(disguised_steps(steps, shuffled, random));
    CHECK(first.report.root_count == second.report.root_count);
    for (std::size_t step = 0; step < steps.size(); ++step)
        CHECK(corner_sets(first.keys[step]) == corner_sets(second.keys[step]));
}

TEST_CASE("given roots become the roots of the keys") {
    std::mt19937 random(3);
    const Hierarchy roots = square_roots(3);
    const auto steps = random_steps(roots, 3, random);
    SeriesOptions options;
    options.roots = &roots;
    const Recovered result = recovered(disguised_steps(steps, {0, true, true, false, 0}, random), options);
    check_keys(result, steps);
    CHECK(result.keys[0].roots == roots.roots);
}

TEST_CASE("a displacement moves the keys, and vertices are identified without it") {
    std::mt19937 random(5);
    auto steps = random_steps(square_roots(3), 3, random);
    std::uniform_real_distribution<double> moved(-1, 1);
    for (FieldMesh& step : steps) {
        MeshField field{"d", 2, {}};
        for (std::size_t p = 0; p < 2 * step.points.size(); ++p) field.values.push_back(moved(random));
        step.point_fields.push_back(field);
        step = disguised(step, {0, false, true, false, 0}, random);
    }
    SeriesOptions options;
    options.displacement = "d";
    const Recovered result = recovered(steps, options);
    for (FieldMesh& step : steps)
        for (std::size_t p = 0; p < step.points.size(); ++p)
            step.points[p] +=
                glm::dvec3(step.point_fields[1].values[2 * p], step.point_fields[1].values[2 * p + 1], 0);
    check_keys(result, steps);
    REQUIRE(result.keys[0].fields.size() == 3);
    CHECK(result.keys[0].fields[1].name == "d x");
    CHECK(result.keys[0].fields[2].name == "d y");
}

TEST_CASE("only the fields that are asked for become fields of the keys") {
    std::mt19937 random(5);
    auto steps = random_steps(square_roots(2), 2, random);
    for (FieldMesh& step : steps)
        step.point_fields.push_back({"v", 3, std::vector<double>(3 * step.points.size(), 1)});
    SeriesOptions options;
    options.fields = {"v"};
    const Recovered result = recovered(steps, options);
    REQUIRE(result.keys[1].fields.size() == 3);
    CHECK(result.keys[1].fields[2].name == "v z");
    CHECK(result.keys[1].fields[2].values[0] == 1);
}

TEST_CASE("the report says how many of its widths a front moves") {
    // A ramp of width 0.2 that moves by 0.1, over a fine mesh.
    std::mt19937 random(1);
    const Hierarchy roots = square_roots(40);
    std::vector<FieldMesh> steps = random_steps(roots, 1, random);
    steps.push_back(steps[0]);
    for (std::size_t step = 0; step < 2; ++step)
        for (std::size_t p = 0; p < steps[step].points.size(); ++p)
            steps[step].point_fields[0].values[p] =
                std::clamp((steps[step].points[p].x - 0.3 - 0.1 * static_cast<double>(step)) / 0.2, 0.0, 1.0);
    const Recovered result = recovered(steps);
    CHECK(result.report.steps[0].moved_widths == doctest::Approx(0.5).epsilon(0.05));
    CHECK(result.report.steps[1].moved_widths == 0);
}

TEST_CASE("progress rises to 1, and an exception out of it ends the recovery") {
    std::mt19937 random(2);
    const auto steps = random_steps(square_roots(2), 3, random);
    double last = 0;
    recover(
        series_of(steps), {}, [](std::size_t, const Hierarchy&) {},
        [&](std::string_view, double part) {
            CHECK(part >= last);
            last = part;
        });
    CHECK(last == 1);
    CHECK_THROWS_AS(recover(
                        series_of(steps), {}, [](std::size_t, const Hierarchy&) {},
                        [](std::string_view, double) { throw 5; }),
                    int);
}

}  // namespace
}  // namespace interleaf
