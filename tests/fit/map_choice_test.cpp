// The choice of a map: in which ways surfaces are mapped, and which keys of matched maps are refused unsmoothed.
#include "fit/map_choice.h"

#include <cmath>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include <doctest/doctest.h>
#include <glm/vec3.hpp>

#include "fit/fit.h"
#include "fit/sphere_map/spherical_map.h"
#include "fit/star_shapes.h"
#include "hierarchy/cube.h"
#include "hierarchy/error.h"

using namespace interleaf;
using interleaf::testing::MappedMesh;

namespace {

/// Judges the map of a body as that of a match.
JudgedMap judge_as_matched(const MappedMesh& body, double least_angle) {
    std::vector<StageTime> times;
    Stopwatch stopwatch(times);
    return judge(std::make_shared<AlignedMap>(body.mesh, SurfaceMesh{}, body.points, false),
                 project_to_sphere(cube()), {}, least_angle, stopwatch, {});
}

/// An ellipsoid of the given length under the map of a sphere, so that triangles are stretched.
MappedMesh long_body(double length) {
    MappedMesh body = testing::unit_sphere_mesh(4);
    for (glm::dvec3& position : body.mesh.positions) position.z *= length;
    return body;
}

bool is_smoothed(const JudgedMap& judged) {
    return judged.quality.hausdorff > 0;  // measured after smoothing only
}

}  // namespace

TEST_CASE(
    "a key of a match with more needles than smoothing mends is refused unsmoothed, if none is accepted") {
    const JudgedMap refused = judge_as_matched(long_body(40), 3);
    CHECK_FALSE(is_smoothed(refused));
    CHECK(refused.quality.min_angle < 3);
    const JudgedMap accepted_anyway = judge_as_matched(long_body(40), 0);
    CHECK(is_smoothed(accepted_anyway));
    CHECK(accepted_anyway.quality.min_angle > refused.quality.min_angle);
    CHECK(is_smoothed(judge_as_matched(long_body(3), 3)));
}

TEST_CASE("a key of a match of which too many leaves are turned over is refused unsmoothed") {
    MappedMesh rough = testing::unit_sphere_mesh(6);
    for (std::size_t v = 0; v < rough.points.size(); ++v)
        rough.mesh.positions[v] *= 1 + 0.08 * std::sin(1e4 * double(v));
    const JudgedMap refused = judge_as_matched(rough, 0);
    CHECK_FALSE(is_smoothed(refused));
    CHECK(double(refused.quality.flipped_leaves) > 2 * FitLimits().flipped_part * 20000);
}

TEST_CASE(
    "a fine mesh of a body with long arms has another map where crowded vertices are relaxed, also one to "
    "one") {
    const SurfaceMesh mesh = testing::six_arms(5).mesh;
    REQUIRE(is_only_mapped_as_it_is(mesh));
    const SphereRoots roots = project_to_sphere(cube());
    const auto map_in = [&](const MappingWay& way) {
        std::vector<StageTime> times;
        Stopwatch stopwatch(times);
        const ChosenMap chosen =
            choose_map(mesh, {.roots = roots, .rotation = glm::dmat3(1), .way = way}, stopwatch, {});
        return std::get<FoundMap>(chosen).map->points;
    };
    const std::vector<glm::dvec3> usual = map_in({});
    const std::vector<glm::dvec3> relaxed = map_in({.relaxes_crowded = true});
    CHECK(fault_of_map(mesh, relaxed).empty());
    CHECK(usual != relaxed);
}

TEST_CASE("a refused key of a fine mesh is tried in three ways, that of a coarse mesh in two") {
    for (const unsigned divisions : {1U, 5U}) {
        CAPTURE(divisions);
        const SurfaceMesh mesh = testing::bumpy_ellipsoid(divisions).mesh;
        bool is_second_tried = false;
        bool is_last_tried = false;
        double reached = 0;
        const auto note = [&](std::string_view stage, double part) {
            CHECK(part >= reached);
            reached = part;
            if (stage != "mapping to the sphere") return true;
            is_second_tried = is_second_tried || (part > 0.91 && part < 0.955);
            is_last_tried = is_last_tried || part > 0.955;
            return true;
        };
        CHECK_THROWS_AS(fit(mesh, {.limits = {.hausdorff = 1e-9}}, note), InputError);
        CHECK(is_second_tried == (divisions == 5));
        CHECK(is_last_tried);
    }
}
