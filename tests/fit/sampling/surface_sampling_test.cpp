// Sampling: the properties of a key of a mapped surface, on surfaces whose map is known.
#include "fit/sampling/surface_sampling.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <vector>

#include "sanitized.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "fit/fit_quality.h"
#include "fit/landmarks/landmark_report.h"
#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"
#include "fit/sphere_map/alignment.h"
#include "fit/star_shapes.h"
#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/checker.h"
#include "hierarchy/cube.h"
#include "hierarchy/greedy.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

SampledSurface sampled(const MappedMesh& mapped, const SamplingOptions& options,
                       const SphereRoots& roots = project_to_sphere(cube())) {
    return sample_surface(MappedSurface(mapped.mesh, mapped.points), roots, options, {});
}

/// Sampling by definition, without leveling: locates every leaf's places, and finds the vertices of the
/// surface in the leaf, without earlier results.
std::vector<Triangle> literally_sampled(const MappedMesh& mapped, const SphereRoots& roots, Index leaves) {
    const SphereLocation location(mapped.mesh.triangles, mapped.points);
    const auto position = [&](Index vertex) { return mapped.mesh.positions[vertex]; };
    const auto on_surface = [&](const glm::dvec3& direction) {
        return location.locate(glm::normalize(direction))
            .of(std::span(mapped.mesh.triangles), std::span(mapped.mesh.positions));
    };
    const auto normal_at = [&](const glm::dvec3& direction) {
        const auto& [a, b, c] = mapped.mesh.triangles[location.locate(glm::normalize(direction)).triangle];
        return unit_normal({position(a), position(b), position(c)});
    };
    std::vector<glm::dvec3> points = roots.points;
    std::vector<glm::vec3> root_positions;
    root_positions.reserve(points.size());
    for (const glm::dvec3& point : points) root_positions.emplace_back(on_surface(point));
    AdaptiveMesh mesh(roots.complex, root_positions, [&](Index a, Index b, Index) {
        points.push_back(glm::normalize(points[a] + points[b]));
        return glm::vec3(on_surface(points.back()));
    });
    const auto error = [&](const AdaptiveMesh& refined, Index leaf) {
        const auto& [a, b, c] = refined.vertices(leaf);
        const auto positions = refined.positions();
        const TriangleCorners corners = {positions[a], positions[b], positions[c]};
        const glm::dvec3 &u = points[a], &v = points[b], &w = points[c];
        double squared = 0;
        double turn = 0;
        const auto measure = [&](const glm::dvec3& point) {
            squared = std::max(squared, squared_distance_to_triangle(point, corners));
        };
        for (const glm::dvec3& inside : {u + v, v + w, w + u, u + v + w}) {
            measure(on_surface(inside));
            turn = std::max(turn, glm::distance(normal_at(inside), unit_normal(corners)));
        }
        for (std::size_t i = 0; i < mapped.points.size(); ++i) {
            const glm::dvec3& p = mapped.points[i];
            if (side_of_arc(u, v, p) >= 0 && side_of_arc(v, w, p) >= 0 && side_of_arc(w, u, p) >= 0)
                measure(mapped.mesh.positions[i]);
        }
        const double size =
            std::max({glm::distance(corners[0], corners[1]), glm::distance(corners[1], corners[2]),
                      glm::distance(corners[2], corners[0])});
        return std::sqrt(squared) + 0.1 * size * turn;
    };
    refine_greedily(mesh, error, {.leaves = leaves});
    std::vector<Triangle> triangles;
    for (const Index leaf : mesh.preorder()) triangles.push_back(mesh.vertices(leaf));
    return triangles;
}

std::vector<MappedMesh> meshes_to_level() {
    if (is_sanitized) return {six_arms(4)};
    return {bumpy_ellipsoid(3), ball_with_spike(4), six_arms(4)};
}

/// The surface that \p located maps to \p directions, which are not of length 1, without leaves.
SampledSurface points_of(const MappedSurface& located, std::span<const glm::dvec3> directions) {
    SampledSurface surface;
    for (const glm::dvec3& direction : directions) {
        surface.sphere_points.push_back(glm::normalize(direction));
        surface.mesh_points.push_back(located.location.locate(surface.sphere_points.back()));
        surface.positions.emplace_back(located.position(surface.mesh_points.back()));
    }
    return surface;
}

}  // namespace

TEST_CASE("a leaf around a sharp rim faces away from one of the sides, but is not turned over") {
    MappedMesh lens = unit_sphere_mesh(5);
    for (glm::dvec3& position : lens.mesh.positions) position.z *= 0.001;
    const MappedSurface located(lens.mesh, lens.points);
    const auto on_sphere = [](double y, double z) { return glm::dvec3(std::sqrt(1 - y * y - z * z), y, z); };
    // Three of the four places are below the rim, and the leaf looks up.
    const std::vector<glm::dvec3> around{on_sphere(0, 0.6), on_sphere(-0.2, -0.35), on_sphere(0.2, -0.35)};
    CHECK(faces_away({0, 1, 2}, points_of(located, around), located));
    CHECK_FALSE(is_turned_over({0, 1, 2}, points_of(located, around), located));
    CHECK_FALSE(faces_away({0, 2, 1}, points_of(located, around), located));
    CHECK_FALSE(is_turned_over({0, 2, 1}, points_of(located, around), located));

    const std::vector<glm::dvec3> above{on_sphere(0, 0.8), on_sphere(-0.2, 0.4), on_sphere(0.2, 0.4)};
    CHECK_FALSE(faces_away({0, 1, 2}, points_of(located, above), located));
    CHECK_FALSE(is_turned_over({0, 1, 2}, points_of(located, above), located));
    CHECK(faces_away({0, 2, 1}, points_of(located, above), located));
    CHECK(is_turned_over({0, 2, 1}, points_of(located, above), located));
    CHECK(is_turned_over({0, 1, 1}, points_of(located, above), located));
}

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

TEST_CASE("what leaves keep for their children is what the children would find") {
    for (const Hierarchy& roots_key : {cube(), octahedron()}) {
        const SphereRoots roots = project_to_sphere(roots_key);
        MappedMesh mapped = bumpy_ellipsoid(3);
        // Turned, so that no vertex of the surface lies on an edge between leaves.
        rotate(mapped.points, glm::dmat3(glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(1, 2, 3))));
        const SampledSurface surface = sampled(mapped, {.leaves = 1500, .max_leveling = 0}, roots);
        std::vector<Triangle> triangles;
        for (const Leaf& leaf : surface.leaves) triangles.push_back(leaf.vertices);
        CHECK(triangles == literally_sampled(mapped, roots, 1500));
    }
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
    // Far thinner than the first leaves: for many levels, no middle of an edge or of a leaf comes near it.
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

TEST_CASE("leveling brings the farthest places nearer with as many leaves") {
    for (const MappedMesh& mapped : meshes_to_level()) {
        CAPTURE(mapped.points.size());
        const MappedSurface located(mapped.mesh, mapped.points);
        const SampledSurface levelled = sampled(mapped, {.leaves = 5000});
        const SampledSurface not_levelled = sampled(mapped, {.leaves = 5000, .max_leveling = 0});
        CHECK(levelled.leaves.size() <= 5000);
        CHECK(not_levelled.leaves.size() > 4990);
        CHECK(measure_quality(located, levelled, {}).hausdorff <
              0.9 * measure_quality(located, not_levelled, {}).hausdorff);
    }
}

TEST_CASE("a tolerance takes no more leaves than reach it without one") {
    for (const MappedMesh& mapped : meshes_to_level()) {
        CAPTURE(mapped.points.size());
        const MappedSurface located(mapped.mesh, mapped.points);
        const double reached = measure_quality(located, sampled(mapped, {.leaves = 5000}), {}).hausdorff;
        const SampledSurface within =
            sampled(mapped, {.leaves = 100000, .tolerance = reached * box_diagonal(mapped.mesh)});
        CHECK(within.leaves.size() < 5000);
        CHECK(measure_quality(located, within, {}).hausdorff < 1.1 * reached);
    }
}

TEST_CASE("the key is near a landmark, also along the surface") {
    // On a slab, the leaves of whose faces have no error, whatever part of a face they show.
    MappedMesh slab = unit_sphere_mesh(4);
    for (glm::dvec3& position : slab.mesh.positions) {
        position /= std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)});
        position.x *= 2 + position.x;
    }
    const SphereRoots roots = project_to_sphere(cube());
    const auto farthest_with = [&](const SamplingOptions& options, std::span<const glm::dvec3> held) {
        const SampledSurface surface =
            sample_surface(MappedSurface(slab.mesh, slab.points, held), roots, options, {});
        const Hierarchy key = hierarchy_from_leaves(roots.complex, surface.leaves, surface.positions);
        double farthest = 0;
        for (std::size_t v = 0; v < slab.points.size(); v += 37)
            farthest = std::max(farthest, glm::distance(slab.mesh.positions[v],
                                                        point_in_direction(key, roots, slab.points[v])));
        return farthest;
    };
    std::vector<glm::dvec3> landmarks;
    for (std::size_t v = 0; v < slab.points.size(); v += 37) landmarks.push_back(slab.mesh.positions[v]);
    const double farthest = farthest_with({.leaves = 3000}, landmarks);
    CHECK(farthest_with({.leaves = 3000}, {}) > 1.5 * farthest);
    CHECK(farthest_with({.leaves = 100000, .tolerance = 0.05}, {}) > 0.05);
    CHECK(farthest_with({.leaves = 100000, .tolerance = 0.05}, landmarks) <= 0.05);
}

TEST_CASE("the roots alone are a key") {
    const SampledSurface surface = sampled(unit_sphere_mesh(2), {.leaves = 12});
    CHECK(surface.leaves.size() == 12);
    CHECK(surface.positions.size() == 8);
}
