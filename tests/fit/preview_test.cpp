// Quick keys for the landmark window: landmarks of the two keys lie on each other.
#include "fit/preview.h"

#include <cstddef>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/landmarks/landmark_report.h"
#include "fit/star_shapes.h"
#include "hierarchy/cube.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

const PreviewOptions coarse = {.roots = project_to_sphere(cube()), .leaves = 1500};

}  // namespace

TEST_CASE("the sphere points of a key are those over which its vertices lie") {
    const MappedMesh body = bumpy_ellipsoid(3);
    const PreviewReference reference = preview_reference(body.mesh, coarse, {});
    const std::vector<glm::dvec3> points = sphere_points_of(reference.key, coarse.roots);
    REQUIRE(points.size() == reference.key.positions.size());
    for (std::size_t v = 0; v < points.size(); v += 7) {
        CHECK(glm::length(points[v]) == doctest::Approx(1));
        CHECK(glm::distance(point_in_direction(reference.key, coarse.roots, points[v]),
                            glm::dvec3(reference.key.positions[v])) < 1e-5);
    }
}

TEST_CASE(
    "a quick key has its landmarks where the reference has their targets, also a reference that is a key") {
    const PreviewReference body = preview_reference(bumpy_ellipsoid(3).mesh, coarse, {});
    const PreviewReference key = preview_reference(body.key, coarse.roots);
    const MappedMesh other = unit_sphere_mesh(3);
    for (const PreviewReference* reference : {&body, &key}) {
        std::vector<Landmark> first;
        AimedLandmarks aimed;
        for (const glm::dvec3& direction :
             {glm::dvec3(1, 0.1, 0), glm::dvec3(-0.1, 1, 0), glm::dvec3(0, 0.1, 1), glm::dvec3(-1, 0, 0.1)}) {
            const std::string name = std::to_string(first.size());
            first.push_back({name, 2.0 * direction});
            aimed.landmarks.push_back({name, 2.0 * direction});
        }
        const std::vector<Landmark> targets = targets_on(*reference, first);
        for (std::size_t k = 0; k < targets.size(); ++k) {
            aimed.landmarks[k].direction = targets[k].direction;
            aimed.positions.push_back(targets[k].position);
        }
        const PreviewKey made = preview_key(other.mesh, aimed, {}, coarse, {});
        CHECK(made.agreement.ways.size() == aimed.landmarks.size());
        for (const Landmark& target : targets)
            CHECK(glm::distance(point_in_direction(reference->key, coarse.roots, *target.direction),
                                target.position) < 0.1);
        for (const Landmark& landmark : aimed.landmarks)
            CHECK(glm::distance(point_in_direction(made.key, coarse.roots, *landmark.direction),
                                glm::normalize(landmark.position)) < 0.05);
    }
    CHECK(preview_key(other.mesh, {}, {}, coarse, {}).faults.empty());
}
