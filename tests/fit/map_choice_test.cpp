// The choice of a map: which keys of matched maps are refused before they are smoothed.
#include "fit/map_choice.h"

#include <cmath>
#include <memory>
#include <vector>

#include <doctest/doctest.h>
#include <glm/vec3.hpp>

#include "fit/star_shapes.h"
#include "hierarchy/cube.h"

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
