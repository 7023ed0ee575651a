// Sampling: what a key of a mapped surface must be, on surfaces whose map is known.
#include "fit/surface_sampling.h"

#include <cstring>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/star_shapes.h"
#include "fit/surface_distance.h"
#include "hierarchy/checker.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

SampledSurface sampled(const MappedMesh& mapped, const SamplingOptions& options,
                       const SphereRoots& roots = project_to_sphere(cube())) {
    const SphereLocation location(mapped.mesh.triangles, mapped.points);
    return sample_surface(mapped.mesh, mapped.points, location, roots, options, {});
}

}  // namespace

TEST_CASE("the key is sound, over the given roots, and its vertices lie on the surface") {
    for (const Hierarchy& roots_key : {cube(), octahedron()}) {
        const SphereRoots roots = project_to_sphere(roots_key);
        const MappedMesh mapped = bumpy_ellipsoid(4);
        const SampledSurface surface = sampled(mapped, {.leaves = 3000}, roots);
        CHECK(surface.leaves.size() <= 3000);
        CHECK(surface.leaves.size() > 2990);
        const Hierarchy key = hierarchy_from_leaves(roots.complex, surface.leaves, surface.positions);
        CHECK(check(key).empty());
        CHECK(key.roots == roots.complex);
        const SurfaceDistance distance(mapped.mesh.triangles, mapped.mesh.positions);
        Index nearest = no_index;
        for (const glm::vec3& position : surface.positions) CHECK(distance(position, nearest) < 1e-6);
    }
}

TEST_CASE("on the unit sphere, a vertex lies where its point of the sphere is") {
    const SampledSurface surface = sampled(unit_sphere_mesh(3), {.leaves = 3000});
    for (std::size_t v = 0; v < surface.positions.size(); ++v)
        CHECK(glm::distance(glm::normalize(glm::dvec3(surface.positions[v])), surface.sphere_points[v]) <
              1e-6);
}

TEST_CASE("the same surface gives the same bits") {
    const MappedMesh mapped = bumpy_ellipsoid(3);
    const SampledSurface first = sampled(mapped, {.leaves = 2000});
    const SampledSurface again = sampled(mapped, {.leaves = 2000});
    REQUIRE(first.positions.size() == again.positions.size());
    CHECK(std::memcmp(first.positions.data(), again.positions.data(),
                      first.positions.size() * sizeof(glm::vec3)) == 0);
    CHECK(first.leaves.size() == again.leaves.size());
}

TEST_CASE("a spike that a single vertex makes is found") {
    // Far thinner than the first leaves: no middle of an edge or of a leaf comes near it for many levels.
    for (const unsigned divisions : {4U, 6U}) {
        const SampledSurface surface = sampled(ball_with_spike(divisions), {.leaves = 1000});
        float highest = 0;
        for (const glm::vec3& position : surface.positions) highest = std::max(highest, position.z);
        CHECK(highest > 2.8F);
    }
}

TEST_CASE("all vertices of the surface are near the key when it is sampled within a tolerance") {
    const MappedMesh mapped = bumpy_ellipsoid(4);
    std::size_t leaves_before = 0;
    for (const double tolerance : {0.1, 0.02, 0.005}) {
        CAPTURE(tolerance);
        const SampledSurface surface = sampled(mapped, {.leaves = 100000, .tolerance = tolerance});
        CHECK(surface.leaves.size() > leaves_before);
        leaves_before = surface.leaves.size();
        std::vector<Triangle> triangles;
        for (const Leaf& leaf : surface.leaves) triangles.push_back(leaf.vertices);
        const std::vector<glm::dvec3> positions(surface.positions.begin(), surface.positions.end());
        const SurfaceDistance distance(triangles, positions);
        Index nearest = no_index;
        for (const glm::dvec3& position : mapped.mesh.positions)
            CHECK(distance(position, nearest) <= tolerance + 1e-6);
    }
}

TEST_CASE("the roots alone are a key") {
    const SampledSurface surface = sampled(unit_sphere_mesh(2), {.leaves = 12});
    CHECK(surface.leaves.size() == 12);
    CHECK(surface.positions.size() == 8);
}
