// Smoothing: it keeps what it must of a sampled surface, and improves the leaves.
#include "fit/sampling/leaf_smoothing.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/fit_quality.h"
#include "fit/landmarks/landmark_report.h"
#include "fit/mesh/surface_distance.h"
#include "fit/star_shapes.h"
#include "hierarchy/checker.h"
#include "hierarchy/cube.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// A sampled surface before and after.
struct Smoothed {
    MappedMesh mapped;
    SphereRoots roots = project_to_sphere(cube());
    MappedSurface located{mapped.mesh, mapped.points};
    SampledSurface before;
    SampledSurface after;

    Smoothed(MappedMesh mesh, Index leaves) : mapped(std::move(mesh)) {
        before = sample_surface(located, roots, {.leaves = leaves}, {});
        after = before;
        smooth_leaves(located, roots.complex.vertex_count(), after, {});
    }
    Smoothed(const Smoothed&) = delete;  // located refers to mapped
    Smoothed& operator=(const Smoothed&) = delete;
    ~Smoothed() = default;

    FitQuality quality(const SampledSurface& surface) const { return measure_quality(located, surface, {}); }
};

std::vector<MappedMesh> meshes_to_smooth() {
    return {bumpy_ellipsoid(4), ball_with_spike(4), six_arms(4)};
}

double farthest_vertex(const SurfaceMesh& mesh, const SampledSurface& surface) {
    std::vector<Triangle> triangles;
    for (const Leaf& leaf : surface.leaves) triangles.push_back(leaf.vertices);
    const std::vector<glm::dvec3> positions(surface.positions.begin(), surface.positions.end());
    const SurfaceDistance distance(triangles, positions);
    Index nearest = no_index;
    double farthest = 0;
    for (const glm::dvec3& position : mesh.positions)
        farthest = std::max(farthest, distance(position, nearest));
    return farthest;
}

}  // namespace

TEST_CASE("smoothing makes no measure of a key worse") {
    for (MappedMesh& mesh : meshes_to_smooth())
        for (const Index leaves : {500U, 3000U}) {
            const Smoothed smoothed(mesh, leaves);
            CAPTURE(mesh.points.size());
            CAPTURE(leaves);
            const FitQuality before = smoothed.quality(smoothed.before);
            const FitQuality after = smoothed.quality(smoothed.after);
            CHECK(after.min_angle >= before.min_angle - 1e-3);
            CHECK(after.flipped_leaves <= before.flipped_leaves);
            CHECK(after.hausdorff <= 1.02 * before.hausdorff);
            CHECK(after.euler == 2);
            CHECK(farthest_vertex(smoothed.mapped.mesh, smoothed.after) <=
                  farthest_vertex(smoothed.mapped.mesh, smoothed.before) + 1e-9);
        }
}

TEST_CASE("smoothing makes the least angle of a body with arms larger") {
    const Smoothed smoothed(six_arms(5), 3000);
    const FitQuality before = smoothed.quality(smoothed.before);
    REQUIRE(before.min_angle < 15);
    CHECK(smoothed.quality(smoothed.after).min_angle > before.min_angle + 1);
}

TEST_CASE(
    "smoothed leaves stay one to one with their parts of the sphere, and their vertices on the surface") {
    for (MappedMesh& mesh : meshes_to_smooth()) {
        const Smoothed smoothed(std::move(mesh), 3000);
        const SampledSurface& surface = smoothed.after;
        const auto& points = surface.sphere_points;
        for (const auto& [vertices, level] : surface.leaves)
            CHECK(side_of_arc(points[vertices[0]], points[vertices[1]], points[vertices[2]]) > 0);
        const SurfaceDistance distance(smoothed.mapped.mesh.triangles, smoothed.mapped.mesh.positions);
        Index nearest = no_index;
        for (const glm::vec3& position : surface.positions) CHECK(distance(position, nearest) < 1e-6);
        CHECK(
            check(hierarchy_from_leaves(smoothed.roots.complex, surface.leaves, surface.positions)).empty());
    }
}

TEST_CASE("smoothing leaves root vertices where they are, and does the same each time") {
    const Smoothed first(ball_with_spike(4), 3000);
    const Smoothed again(ball_with_spike(4), 3000);
    const std::size_t roots = first.roots.complex.vertex_count();
    CHECK(std::memcmp(first.before.positions.data(), first.after.positions.data(),
                      roots * sizeof(glm::vec3)) == 0);
    const std::size_t bytes = first.after.positions.size() * sizeof(glm::vec3);
    CHECK(std::memcmp(first.before.positions.data(), first.after.positions.data(), bytes) != 0);
    REQUIRE(first.after.positions.size() == again.after.positions.size());
    CHECK(std::memcmp(first.after.positions.data(), again.after.positions.data(), bytes) == 0);
}

TEST_CASE("smoothing leaves landmarks near the points of the key in their directions") {
    const MappedMesh mapped = six_arms(5);
    const SphereRoots roots = project_to_sphere(cube());
    const double near = 0.002 * box_diagonal(mapped.mesh);
    std::vector<glm::dvec3> landmarks;
    std::vector<glm::dvec3> directions;
    for (std::size_t v = 0; v < mapped.points.size(); v += 10) {
        landmarks.push_back(mapped.mesh.positions[v]);
        directions.push_back(mapped.points[v]);
    }
    const auto distances_of = [&](const SampledSurface& surface) {
        const Hierarchy key = hierarchy_from_leaves(roots.complex, surface.leaves, surface.positions);
        std::vector<double> distances(landmarks.size());
        for (std::size_t k = 0; k < landmarks.size(); ++k)
            distances[k] = glm::distance(landmarks[k], point_in_direction(key, roots, directions[k]));
        return distances;
    };
    const auto moved_away = [&](std::span<const glm::dvec3> held) {
        const MappedSurface located(mapped.mesh, mapped.points, held);
        SampledSurface surface = sample_surface(located, roots, {.leaves = 3000}, {});
        const std::vector<double> before = distances_of(surface);
        smooth_leaves(located, roots.complex.vertex_count(), surface, {});
        const std::vector<double> after = distances_of(surface);
        std::size_t count = 0;
        for (std::size_t k = 0; k < after.size(); ++k) count += after[k] > std::max(near, before[k]) + 1e-6;
        return count;
    };
    CHECK(moved_away({}) > 0);
    CHECK(moved_away(landmarks) == 0);
}

TEST_CASE("a surface without bad leaves is left as it is") {
    const Smoothed smoothed(unit_sphere_mesh(4), 3000);
    const std::size_t bytes = smoothed.before.positions.size() * sizeof(glm::vec3);
    CHECK(std::memcmp(smoothed.before.positions.data(), smoothed.after.positions.data(), bytes) == 0);
}

TEST_CASE("beyond its limit, smoothing goes on with the worst leaves only, or ends") {
    const MappedMesh mapped = six_arms(5);
    const SphereRoots roots = project_to_sphere(cube());
    const MappedSurface located(mapped.mesh, mapped.points);
    const SampledSurface before = sample_surface(located, roots, {.leaves = 3000}, {});
    const auto smoothed = [&](const SmoothingLimits& limits) {
        SampledSurface surface = before;
        smooth_leaves(located, roots.complex.vertex_count(), surface, {}, limits);
        return surface;
    };
    const auto moved = [&](const SampledSurface& surface) {
        std::size_t count = 0;
        for (std::size_t v = 0; v < before.positions.size(); ++v)
            count += before.positions[v] != surface.positions[v];
        return count;
    };
    CHECK(moved(smoothed({.tries = 0})) == 0);
    const SampledSurface one_round = smoothed({.tries = 1});
    const SampledSurface worst_go_on = smoothed({.tries = 1, .tries_of_worst = 20});
    CHECK(moved(one_round) > 0);
    CHECK(measure_shapes(located, worst_go_on).min_angle >= measure_shapes(located, one_round).min_angle);
    const SampledSurface few = smoothed({.tries = 0, .tries_of_worst = 3});
    CHECK(moved(few) > 0);
    CHECK(moved(few) <= 18);  // in six rounds
    const SampledSurface short_rounds = smoothed({.tries_per_round = 3});
    CHECK(moved(short_rounds) > 0);
    CHECK(moved(short_rounds) <= 18);
}

TEST_CASE("needles are mended at the cost of a little distance") {
    const MappedMesh mapped = six_arms(5);
    const SphereRoots roots = project_to_sphere(cube());
    const MappedSurface located(mapped.mesh, mapped.points);
    const SampledSurface before = sample_surface(located, roots, {.leaves = 3000}, {});
    const auto smoothed = [&](double needle_angle) {
        SampledSurface surface = before;
        smooth_leaves(located, roots.complex.vertex_count(), surface, {}, {.needle_angle = needle_angle});
        return surface;
    };
    const SampledSurface plain = smoothed(0);
    REQUIRE(measure_shapes(located, plain).min_angle < 13);
    const FitQuality mended = measure_quality(located, smoothed(13), {});
    CHECK(mended.min_angle >= 13);
    CHECK(mended.hausdorff <= 1.3 * measure_quality(located, plain, {}).hausdorff);
    CHECK(mended.flipped_leaves == 0);
    const FitQuality farther = measure_quality(located, smoothed(15), {});  // the first distance does not do
    CHECK(farther.min_angle > 13.5);
    CHECK(farther.hausdorff <= 1.7 * measure_quality(located, plain, {}).hausdorff);
    CHECK(farther.flipped_leaves == 0);
    SampledSurface limited = before;
    smooth_leaves(located, roots.complex.vertex_count(), limited, {},
                  {.needle_angle = 15, .needle_distance = 0});
    const FitQuality as_near = measure_quality(located, limited, {});
    CHECK(as_near.min_angle < farther.min_angle);
    CHECK(as_near.hausdorff < farther.hausdorff);
}

TEST_CASE("the vertices of an approximated surface are put onto it, and none of them leaves it again") {
    const MappedMesh mapped = six_arms(4);
    const SphereRoots roots = project_to_sphere(cube());
    const MappedSurface located(mapped.mesh, mapped.points);
    std::vector<glm::dvec3> positions = mapped.mesh.positions;
    for (glm::dvec3& position : positions) position *= 1.001;
    const SurfaceDistance original(mapped.mesh.triangles, positions);
    const auto farthest_in = [&](const SampledSurface& surface) {
        double farthest = 0;
        Index nearest = no_index;
        for (const glm::vec3& position : surface.positions)
            farthest = std::max(farthest, original(glm::dvec3(position), nearest));
        return farthest;
    };
    const SampledSurface before = sample_surface(located, roots, {.leaves = 3000}, {});
    REQUIRE(farthest_in(before) > 1e-4);
    const auto smoothed = [&](double needle_angle) {
        SampledSurface surface = before;
        smooth_leaves(located, roots.complex.vertex_count(), surface, {}, {.needle_angle = needle_angle},
                      &original);
        return surface;
    };
    const SampledSurface plain = smoothed(0);
    CHECK(farthest_in(plain) < 1e-6);
    const SampledSurface mended = smoothed(17);
    CHECK(farthest_in(mended) < 1e-6);
    CHECK(measure_shapes(located, mended).min_angle > measure_shapes(located, plain).min_angle);
}
