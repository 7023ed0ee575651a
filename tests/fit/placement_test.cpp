// Bodies brought to one size, one place and the right way up.
#include "fit/placement.h"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/closed_meshes.h"
#include "hierarchy/measure.h"

using namespace interleaf;
using namespace interleaf::testing;

TEST_CASE("the axis that points up becomes y, and right stays right-handed") {
    for (const auto& [up, axis] : {std::pair(UpAxis::x, glm::dvec3(1, 0, 0)),
                                   {UpAxis::y, glm::dvec3(0, 1, 0)},
                                   {UpAxis::z, glm::dvec3(0, 0, 1)}}) {
        std::vector<glm::dvec3> turned{axis, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        turn_up(turned, up);
        CHECK(turned[0] == glm::dvec3(0, 1, 0));
        CHECK(glm::dot(glm::cross(turned[1], turned[2]), turned[3]) == 1);
    }
}

TEST_CASE("size and center are those of the area, not of the vertices") {
    // Vertices crowd at one end of a long box; its area does not.
    const SurfaceMesh ball =
        moved(icosphere(3), [](const glm::dvec3& p) { return 2.0 * p + glm::dvec3(5, 0, 0); });
    const SurfaceExtent extent = extent_of(ball);
    CHECK(extent.size == doctest::Approx(std::sqrt(4 * 3.14159265 * 4)).epsilon(0.01));
    CHECK(glm::distance(extent.center, glm::dvec3(5, 0, 0)) < 1e-9);
}

TEST_CASE("a body gets the size and the center of the first, its dropped parts with it") {
    const SurfaceExtent first = extent_of(moved(icosphere(2), [](const glm::dvec3& p) { return p + 7.0; }));
    CleanMesh other = clean_up(
        joined(moved(icosphere(2), [](const glm::dvec3& p) { return 30.0 * p * glm::dvec3(1, 2, 1); }),
               moved(icosphere(1), [](const glm::dvec3& p) { return p + 100.0; })),
        {});
    const SurfaceExtent before = extent_of(other.mesh);
    const double gap = glm::distance(extent_of(other.dropped).center, before.center);

    CleanMesh same = other;
    place(same, first, {});
    CHECK(same.mesh.positions == other.mesh.positions);

    CleanMesh sized = other;
    place(sized, first, {.same_size = true});
    CHECK(extent_of(sized.mesh).size == doctest::Approx(first.size));
    CHECK(glm::distance(extent_of(sized.mesh).center, before.center) < 1e-9);

    place(other, first, {.same_size = true, .same_center = true});
    CHECK(extent_of(other.mesh).size == doctest::Approx(first.size));
    CHECK(glm::distance(extent_of(other.mesh).center, first.center) < 1e-9);
    CHECK(glm::distance(extent_of(other.dropped).center, first.center) ==
          doctest::Approx(gap * first.size / before.size));
}

TEST_CASE("sizes of another order and boxes that do not touch are told of") {
    const SurfaceExtent first = extent_of(icosphere(1));
    const auto fault_of = [&](double scale, double offset) {
        return fault_of_placing(first, extent_of(moved(icosphere(1), [&](const glm::dvec3& p) {
                                    return scale * p + glm::dvec3(offset, 0, 0);
                                })));
    };
    CHECK(fault_of(1, 0).empty());
    CHECK(fault_of(2.9, 0).empty());
    CHECK(fault_of(1, 1.9).empty());
    CHECK(fault_of(3.1, 0).find("3.1 times as large as the first") != std::string::npos);
    CHECK(fault_of(0.2, 0).find("5 times as small as the first") != std::string::npos);
    CHECK(fault_of(1, 2.1).find("boxes do not touch") != std::string::npos);
}
