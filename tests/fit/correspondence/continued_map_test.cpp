// A map that is continued to the next mesh of a surface that moves: like parts stay at like places of the sphere.
#include "fit/correspondence/continued_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/fit.h"
#include "fit/sphere_map/spherical_map.h"
#include "fit/star_shapes.h"
#include "hierarchy/error.h"
#include "hierarchy/progress.h"

using namespace interleaf;
using interleaf::testing::MappedMesh;

namespace {

constexpr std::size_t few_vertices = 3000;

/// A body with a bump on one side, whose height is \p height; its points on the sphere are its directions.
MappedMesh bumped(unsigned divisions, double pull, double height) {
    MappedMesh body = testing::unit_sphere_mesh(divisions);
    for (std::size_t v = 0; v < body.points.size(); ++v) {
        body.points[v] = glm::normalize(body.points[v] + pull * glm::dvec3(0.3, -0.8, 0.5));
        const glm::dvec3 away = body.points[v] - glm::dvec3(1, 0, 0);
        body.mesh.positions[v] = (1 + height / (1 + 4 * glm::dot(away, away))) * body.points[v];
    }
    return body;
}

/// The largest distance of a point of \p map from the direction of its vertex in \p body.
double largest_error(const ContinuedMap& map, const MappedMesh& body) {
    const std::vector<glm::dvec3> points = with_restored_shapes(map, 4, {});
    REQUIRE(points.size() == map.mesh.positions.size());
    CHECK(fault_of_map(map.mesh, points) == "");
    double largest = 0;
    for (std::size_t v = 0; v < body.points.size(); ++v)
        largest = std::max(largest, glm::distance(points[v], body.points[v]));
    return largest;
}

}  // namespace

TEST_CASE("a map is continued where a body moves, grows or changes a little, on another mesh") {
    const MappedMesh before = bumped(4, 0, 0.3);
    const auto continued_to = [&](const MappedMesh& body) {
        return largest_error(continued_map(before.mesh, before.points, body.mesh, few_vertices, {}), body);
    };
    const MappedMesh same = bumped(3, 0.2, 0.3);
    CHECK(continued_to(same) < 0.02);
    MappedMesh moved = same;
    for (glm::dvec3& position : moved.mesh.positions) position += glm::dvec3(3, -1, 2);
    CHECK(continued_to(moved) < 0.03);
    MappedMesh grown = same;
    for (glm::dvec3& position : grown.mesh.positions) position *= 5;
    CHECK(continued_to(grown) < 0.05);
    CHECK(continued_to(bumped(3, 0.2, 0.36)) < 0.05);
}

TEST_CASE("no map is continued to a body that is far from the one before") {
    const MappedMesh before = bumped(3, 0, 0);
    MappedMesh flat = bumped(3, 0.2, 0);
    for (glm::dvec3& position : flat.mesh.positions) position.z *= 0.3;
    CHECK(continued_map(before.mesh, before.points, flat.mesh, few_vertices, {}).points.empty());
}

TEST_CASE("a key that continues another one is as good as one with a map of its own") {
    const MappedMesh first = bumped(4, 0, 0.3);
    const MappedMesh second = bumped(4, 0.2, 0.33);
    const FitOptions options{.leaves = 2000};
    const FittedKey before = fit(first.mesh, options);
    const FittedKey alone = fit(second.mesh, options);
    const auto continued =
        fit_continued(clean_up(second.mesh, {}), before, alone.report.at_20000_leaves, options);
    REQUIRE(continued);
    CHECK(continued->hierarchy.leaf_count() == alone.hierarchy.leaf_count());
    CHECK(continued->report.quality.hausdorff < 1.3 * alone.report.quality.hausdorff + 2e-4);
    CHECK(continued->mesh.positions == second.mesh.positions);
    const FitOptions strict{.leaves = 2000, .limits = {.hausdorff = 1e-9}};
    CHECK_FALSE(fit_continued(clean_up(second.mesh, {}), before, alone.report.at_20000_leaves, strict));
}

TEST_CASE("a map is not continued if no key can be made with it, as where a tolerance is out of reach") {
    const MappedMesh first = bumped(3, 0, 0.3);
    const FitOptions options{.leaves = 2000};
    const FittedKey before = fit(first.mesh, options);
    const CleanMesh clean = clean_up(bumped(3, 0.2, 0.33).mesh, {});
    int faults = 0;
    double reached = 0;
    const Progress faulty = [&](std::string_view stage, double part) {
        CHECK(part >= reached);
        reached = part;
        if (part < 0.9 || stage == "continuing the map") return true;  // the map is judged before
        ++faults;
        throw InputError("no key");
    };
    CHECK_FALSE(fit_continued(clean, before, before.report.at_20000_leaves, options, faulty));
    CHECK(faults > 1);
    const Progress cancel = [](std::string_view, double part) { return part < 0.9; };
    CHECK_THROWS_AS(fit_continued(clean, before, before.report.at_20000_leaves, options, cancel), Cancelled);
}
