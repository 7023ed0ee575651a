// Meshes that approximate surfaces of long needles, and the keys that they give.
#include "fit/sphere_map/surface_approximation.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/closed_meshes.h"
#include "fit/fit.h"
#include "fit/mesh/surface_distance.h"
#include "fit/sphere_map/spherical_map.h"
#include "fit/sphere_map/surface_refinement.h"
#include "hierarchy/checker.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

constexpr double deviation = 3e-4;

SurfaceMesh approximated(const SurfaceMesh& mesh) {
    const Progress none;
    ProgressMeter meter(none);
    return refine(mesh, {.deviation = deviation}, meter);
}

/// The largest distance of the vertices of \p mesh, or of the middles of its edges, from \p surface.
double farthest_vertex(const SurfaceMesh& mesh, const SurfaceMesh& surface) {
    const SurfaceDistance distance(surface.triangles, surface.positions);
    double largest = 0;
    Index nearest = no_index;
    for (const glm::dvec3& position : mesh.positions)
        largest = std::max(largest, distance(position, nearest));
    return largest;
}
double farthest_middle(const SurfaceMesh& mesh, const SurfaceMesh& surface) {
    SurfaceMesh middles;
    for (const Triangle& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            middles.positions.push_back(
                (mesh.positions[triangle[k]] + mesh.positions[triangle[(k + 1) % 3]]) / 2.0);
    return farthest_vertex(middles, surface);
}

}  // namespace

TEST_CASE("an approximation has fewer and rounder triangles, and all its vertices lie on the surface") {
    const SurfaceMesh mesh = cylinder(256, 20, Cap::zigzag);
    const SurfaceMesh rough = approximated(mesh);
    CHECK(rough.positions.size() < 6000);
    CHECK(triangle_shapes(mesh).needles > 0.9);
    CHECK(triangle_shapes(rough).needles < 0.1);
    CHECK(std::equal(mesh.positions.begin(), mesh.positions.end(), rough.positions.begin()));
    CHECK(farthest_vertex(rough, mesh) < 1e-9);
    CHECK(farthest_middle(rough, mesh) < 2 * 20 * deviation);
    CHECK(rough.positions.size() - rough.triangles.size() / 2 == 2);
}

TEST_CASE("an approximation that is brought nearer to the surface keeps its map") {
    const SurfaceMesh mesh = cylinder(256, 8, Cap::corner_fan);
    SurfaceMesh rough = approximated(mesh);
    std::vector<glm::dvec3> points = map_to_sphere(rough, {}, Keeps::shapes, 0.01).points;
    const SurfaceMesh before = rough;
    const std::vector<glm::dvec3> points_before = points;
    constexpr double tolerance = 1e-3;
    REQUIRE(farthest_middle(rough, mesh) > tolerance);
    const Progress none;
    ProgressMeter meter(none);
    approximate_closely(mesh, rough, points, tolerance, meter);
    CHECK(farthest_middle(rough, mesh) <= tolerance);
    CHECK(farthest_vertex(rough, mesh) < 1e-9);
    CHECK(points.size() == rough.positions.size());
    CHECK(std::equal(before.positions.begin(), before.positions.end(), rough.positions.begin()));
    CHECK(std::equal(points_before.begin(), points_before.end(), points.begin()));
    CHECK(fault_of_map(rough, points).empty());

    const std::size_t size = rough.positions.size();
    approximate_closely(mesh, rough, points, tolerance, meter);  // nothing is left to do
    CHECK(rough.positions.size() == size);
}

TEST_CASE("cylinders and cones of hundreds of sides become good keys, whose vertices lie on the surface") {
    struct Body {
        SurfaceMesh mesh;
        double min_angle;
    };
    std::vector<Body> bodies = {
        {cylinder(1024, 2, Cap::zigzag), 12},
        {moved(globe(64, 1), [](const glm::dvec3& p) { return p * glm::dvec3(1, 1, 4); }), 8},
        // Its tips become needles when they are put onto the surface.
        {moved(globe(64, 1), [](const glm::dvec3& p) { return p * glm::dvec3(1, 1, 8); }), 4}};
    bodies.resize(trials(static_cast<unsigned>(bodies.size())));
    for (const auto& [mesh, min_angle] : bodies) {
        CAPTURE(mesh.positions.size());
        const FittedKey key = fit(mesh, {});
        CHECK(check(key.hierarchy).empty());
        CHECK(key.report.map_keeps == Keeps::shapes);
        CHECK(key.report.quality.hausdorff < 0.001);
        CHECK(key.report.quality.flipped_leaves < 10);
        CHECK(key.report.quality.min_angle > min_angle);
        SurfaceMesh vertices;
        vertices.positions.assign(key.hierarchy.positions.begin(), key.hierarchy.positions.end());
        CHECK(farthest_vertex(vertices, mesh) < 1e-5);
    }
}

TEST_CASE("a key of a surface of needles meets a tolerance, and has landmarks where the surface has them") {
    const SurfaceMesh mesh = cylinder(100, 2, Cap::zigzag);
    FitOptions options{.tolerance = 5e-4};
    options.landmarks.push_back(
        {.name = "side", .position = (mesh.positions[0] + mesh.positions[101]) / 2.0});
    const FittedKey key = fit(mesh, options);
    CHECK(key.report.quality.hausdorff <= 5e-4);
    REQUIRE(key.report.landmarks.size() == 1);
    const FittedLandmark& landmark = key.report.landmarks.front();
    CHECK(landmark.from_mesh < 1e-9);
    CHECK(glm::distance(landmark.position, options.landmarks.front().position) < 1e-9);
    CHECK(landmark.off_in_key < 1e-3);
}
