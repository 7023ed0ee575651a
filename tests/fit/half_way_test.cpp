// The area of the surface half way between two keys, where it is known.
#include "fit/half_way.h"

#include <numbers>

#include <doctest/doctest.h>
#include <glm/mat3x3.hpp>

#include "fit/sampling/surface_sampling.h"
#include "fit/star_shapes.h"
#include "hierarchy/cube.h"

using namespace interleaf;

namespace {

/// A key of the sphere with radius \p radius, turned by \p turn against its roots.
Hierarchy sphere_key(double radius, const glm::dmat3& turn) {
    testing::MappedMesh sphere = testing::unit_sphere_mesh(4);
    for (glm::dvec3& position : sphere.mesh.positions) position = radius * (turn * position);
    const SphereRoots roots = project_to_sphere(cube());
    const SampledSurface surface =
        sample_surface(MappedSurface(sphere.mesh, sphere.points), roots, {.leaves = 5000}, {});
    return hierarchy_from_leaves(roots.complex, surface.leaves, surface.positions);
}

}  // namespace

TEST_CASE("half way between spheres, a turn costs area, and size costs none") {
    const glm::dmat3 quarter(0, 1, 0, -1, 0, 0, 0, 0, 1);
    const Hierarchy sphere = sphere_key(1, glm::dmat3(1));
    const Hierarchy turned = sphere_key(3, quarter);
    CHECK(half_way_area(sphere, sphere_key(3, glm::dmat3(1)), glm::dmat3(1)) ==
          doctest::Approx(1).epsilon(1e-3));
    CHECK(half_way_area(sphere, turned, glm::transpose(quarter)) == doctest::Approx(1).epsilon(1e-3));
    // The mean of a point and the point a quarter turn away lies on a spheroid, longer than wide by the root of 2.
    const double spheroid = (1 + std::numbers::pi / 2) / 4;
    CHECK(half_way_area(sphere, turned, glm::dmat3(1)) == doctest::Approx(spheroid).epsilon(0.01));
}

TEST_CASE("a matched key is taken unless it loses area half way") {
    CHECK(fault_of_half_way(0.9, 0.8).empty());
    CHECK(fault_of_half_way(0.998, 0.999).empty());
    CHECK(fault_of_half_way(0.774, 0.783) ==
          "half way, the surface keeps 0.774 of the area, 0.783 without matching");
}
