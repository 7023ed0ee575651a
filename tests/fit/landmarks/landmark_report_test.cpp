// What reports say about landmarks in keys.
#include "fit/landmarks/landmark_report.h"

#include <array>
#include <cstdint>
#include <random>
#include <string>

#include "messages.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/fit.h"
#include "fit/star_shapes.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

std::vector<Landmark> some_landmarks(const MappedMesh& body, std::span<const std::size_t> vertices) {
    std::vector<Landmark> landmarks;
    for (const std::size_t v : vertices) landmarks.push_back({std::to_string(v), body.mesh.positions[v]});
    return landmarks;
}

}  // namespace

TEST_CASE("the point of a sphere's key in a direction is that direction") {
    const MappedMesh ball = unit_sphere_mesh(4);
    const FittedKey key = fit_mapped(ball.mesh, ball.points, {.leaves = 3000});
    const SphereRoots roots = FitOptions().roots;
    std::mt19937 random(1);
    std::normal_distribution<double> any;
    for (int trial = 0; trial < 300; ++trial) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
        CHECK(glm::distance(point_in_direction(key.hierarchy, roots, direction), direction) < 0.02);
    }
    for (std::size_t v = 0; v < roots.points.size(); ++v)
        CHECK(glm::distance(point_in_direction(key.hierarchy, roots, roots.points[v]),
                            glm::dvec3(key.hierarchy.positions[v])) < 1e-6);
}

TEST_CASE("a similarity does not distort a morph, and a stretched part does, near its landmark") {
    const MappedMesh ball = unit_sphere_mesh(4);
    const Hierarchy first = fit_mapped(ball.mesh, ball.points, {.leaves = 2000}).hierarchy;
    Hierarchy turned = first;
    for (glm::vec3& p : turned.positions) p = 2.0F * glm::vec3(-p.y, p.x, p.z) + 1.0F;
    const std::vector<glm::dvec3> landmarks = {{0, 0, 1}, {0, 0, -1}};
    CHECK(morph_distortion(first, turned, landmarks).at_90_percent == doctest::Approx(1).epsilon(1e-4));
    Hierarchy stretched = first;
    for (glm::vec3& p : stretched.positions)
        if (p.z < 0) p.z *= 20;
    const MorphDistortion distortion = morph_distortion(first, stretched, landmarks);
    CHECK(distortion.at_90_percent > 3);
    CHECK(distortion.worst == 1);
    CHECK(contains(fault_of_distortion(distortion, "tail"), "around the landmark 'tail'"));
    CHECK(fault_of_distortion({.at_90_percent = 2}, "tail").empty());
}

TEST_CASE("landmarks do not change the first key, and the second key has them where the first has") {
    const MappedMesh first = bumpy_ellipsoid(4);
    const MappedMesh second =
        star_shape(4, [](const glm::dvec3& u) { return 1 + 0.3 * u.x + 0.2 * u.y * u.z; });
    const std::array<std::size_t, 5> vertices = {0, 3, 5, 8, 10};
    const FitOptions plain{.leaves = 3000};
    FitOptions options = plain;
    options.landmarks = some_landmarks(first, vertices);
    options.landmarks.push_back({"on a triangle", (first.mesh.positions[first.mesh.triangles[9][0]] +
                                                   first.mesh.positions[first.mesh.triangles[9][1]] +
                                                   first.mesh.positions[first.mesh.triangles[9][2]]) /
                                                      3.0});
    const FittedKey with = fit(first.mesh, options);
    const FittedKey without = fit(first.mesh, plain);
    CHECK(std::equal(with.hierarchy.positions.begin(), with.hierarchy.positions.end(),
                     without.hierarchy.positions.begin(), without.hierarchy.positions.end()));
    REQUIRE(with.report.landmarks.size() == 6);
    CHECK(with.report.landmark_faults.empty());
    for (const FittedLandmark& each : with.report.landmarks) {
        CHECK(each.from_mesh < 1e-12);
        CHECK(each.off_in_key < 0.005);
        CHECK(glm::length(each.direction) == doctest::Approx(1).epsilon(1e-14));
    }

    options.landmarks = some_landmarks(second, vertices);
    for (std::size_t k = 0; k < vertices.size(); ++k)
        options.landmarks[k].direction = with.report.landmarks[k].direction;
    options.landmarks[2].position *= 1.2;
    const FittedKey other = fit(second.mesh, options);
    CHECK(other.report.mesh_vertices == second.mesh.positions.size());
    REQUIRE(other.report.landmark_faults.size() == 1);
    CHECK(contains(other.report.landmark_faults[0], "'5' is"));
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        CHECK(other.report.landmarks[k].direction == with.report.landmarks[k].direction);
        CHECK(other.report.landmarks[k].off_in_key < 0.0025);
    }
    options.landmarks[0].direction.reset();
    CHECK(contains(text_of_thrown<UsageError>([&] { fit(second.mesh, options); }), "expected all or none"));
    options.landmarks[0].direction = options.landmarks[1].direction;
    CHECK(
        contains(input_error_of([&] { fit(second.mesh, options); }), "'0' and '3' have the same direction"));
    options.counterparts.resize(options.landmarks.size() + 1);
    CHECK(
        contains(text_of_thrown<UsageError>([&] { fit(second.mesh, options); }), "expected one for each of"));
}
