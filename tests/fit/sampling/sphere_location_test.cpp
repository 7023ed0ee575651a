// Location on the sphere finds every direction, also on edges and vertices, and in needles.
#include "fit/sampling/sphere_location.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/closed_meshes.h"
#include "fit/mesh/space_triangle.h"
#include "fit/sphere_map/spherical_map.h"
#include "fit/star_shapes.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// The angle between \p direction and the point found for it.
double miss(const SurfaceMesh& mesh, std::span<const glm::dvec3> points, const SphereLocation& location,
            const glm::dvec3& direction, Index guess) {
    const MeshPoint found = location.locate(direction, guess);
    REQUIRE(found.triangle < mesh.triangles.size());
    const glm::dvec3& weights = found.barycentric;
    CHECK(std::min({weights.x, weights.y, weights.z}) >= 0);
    CHECK(weights.x + weights.y + weights.z == doctest::Approx(1).epsilon(1e-14));
    return glm::distance(glm::normalize(found.of(std::span<const Triangle>(mesh.triangles), points)),
                         direction);
}

}  // namespace

TEST_CASE("every direction is found, on edges and vertices as well, from any guess") {
    const auto stretched = [](const glm::dvec3& p) { return glm::normalize(p * glm::dvec3(1, 1, 1e-4)); };
    const NamedMesh meshes[] = {{"tetrahedron", tetrahedron()},
                                {"icosphere", icosphere(3)},
                                {"globe with needles", globe(60, 40)},
                                {"flattened, so triangles are needles", moved(icosphere(3), stretched)}};
    for (const auto& [name, mesh] : meshes) {
        CAPTURE(name);
        const std::vector<glm::dvec3> points = on_sphere(mesh);
        if (!fault_of_map(mesh, points).empty()) continue;
        const SphereLocation location(mesh.triangles, points);
        double largest = 0;
        const auto look = [&](const glm::dvec3& direction, Index guess) {
            largest = std::max(largest, miss(mesh, points, location, direction, guess));
        };
        std::mt19937 random(1);
        std::normal_distribution<double> normal;
        std::uniform_int_distribution<Index> any(0, static_cast<Index>(mesh.triangles.size() - 1));
        for (int trial = 0; trial < 2000; ++trial)
            look(glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))),
                 trial % 2 == 0 ? no_index : any(random));
        for (const glm::dvec3& point : points) look(point, no_index);
        for (const auto& [a, b, c] : mesh.triangles) {
            look(glm::normalize(points[a] + points[b]), no_index);
            look(glm::normalize(0.9 * points[b] + 0.1 * points[c]), any(random));
        }
        CHECK(largest < 1e-12);
    }
}

TEST_CASE("from a neighbor, the walk crosses the edge between") {
    // A vertex lies in all triangles around it. A search without a guess always finds the same one of them.
    const SurfaceMesh mesh = icosphere(3);
    const std::vector<glm::dvec3> points = on_sphere(mesh);
    const SphereLocation location(mesh.triangles, points);
    for (Index here = 0; here < mesh.triangles.size(); ++here)
        for (Index there = 0; there < mesh.triangles.size(); ++there) {
            const Triangle& triangle = mesh.triangles[there];
            const auto is_here = [&](Index vertex) {
                return std::ranges::find(mesh.triangles[here], vertex) != mesh.triangles[here].end();
            };
            if (here == there || std::ranges::count_if(triangle, is_here) != 2) continue;
            const Index beyond = *std::ranges::find_if_not(triangle, is_here);
            CHECK(location.locate(points[beyond], here).triangle == there);
        }
}

TEST_CASE(
    "the distance from a triangle is that of the nearest of many of its points, also where it is "
    "degenerate") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-1, 1);
    for (int trial = 0; trial < 60; ++trial) {
        const auto any = [&] { return glm::dvec3(place(random), place(random), place(random)); };
        std::array<glm::dvec3, 3> corners = {any(), any(), any()};
        if (trial % 6 == 1) corners[2] = 0.3 * corners[0] + 0.7 * corners[1];
        if (trial % 6 == 2) corners[2] = corners[1];
        if (trial % 6 == 3) corners[2] = corners[1] = corners[0];
        const glm::dvec3 point = 2.0 * any();
        double least = 1e9;
        constexpr int parts = 200;
        for (int i = 0; i <= parts; ++i)
            for (int j = 0; j <= i; ++j)
                least = std::min(
                    least, glm::distance(point, (double(parts - i) * corners[0] + double(i - j) * corners[1] +
                                                 double(j) * corners[2]) /
                                                    double(parts)));
        const double distance = std::sqrt(squared_distance_to_triangle(point, corners));
        CHECK(distance <= least + 1e-12);
        CHECK(distance > least - 0.02);
    }
}
