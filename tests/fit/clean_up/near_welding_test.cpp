// Near welding closes seams, and leaves thin walls alone.
#include "fit/clean_up/near_welding.h"

#include <random>

#include <doctest/doctest.h>

#include "fit/clean_up/clean_up.h"
#include "fit/closed_meshes.h"
#include "hierarchy/measure.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// Gives each triangle its own vertices, moved by up to \p noise along each axis.
SurfaceMesh soup_of(const SurfaceMesh& mesh, double noise, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> offset(-noise, noise);
    SurfaceMesh soup;
    for (const Triangle& triangle : mesh.triangles) {
        const auto first = static_cast<Index>(soup.positions.size());
        for (const Index vertex : triangle)
            soup.positions.push_back(mesh.positions[vertex] +
                                     glm::dvec3(offset(random), offset(random), offset(random)));
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

std::size_t welded(const SurfaceMesh& mesh) {
    std::vector<Triangle> triangles = mesh.triangles;
    const Progress none;
    ProgressMeter meter(none);
    return weld_nearby(mesh.positions, triangles, meter);
}

/// A box of 1 x 1 x \p height without two of its sides. Each of the other walls has two triangles.
SurfaceMesh open_box(double height) {
    SurfaceMesh box;
    for (int i = 0; i < 8; ++i) box.positions.emplace_back(i & 1, (i >> 1) & 1, height * (i >> 2));
    box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}};
    return box;
}

}  // namespace

TEST_CASE("triangles whose corners are equal but for rounding become one closed surface, at every size") {
    for (const double size : {1e-20, 1e-3, 1.0, 1e6, 1e18})
        for (unsigned seed = 1; seed <= 5; ++seed) {
            CAPTURE(size);
            CAPTURE(seed);
            const SurfaceMesh mesh = moved(icosphere(2), [&](const glm::dvec3& p) { return size * p; });
            const SurfaceMesh soup = soup_of(mesh, 2e-7 * size, seed);
            const CleanMesh clean = clean_up(soup, {});
            CHECK(is_closed_manifold(clean.mesh.triangles));
            CHECK(clean.mesh.triangles.size() == mesh.triangles.size());
            CHECK(clean.report.nearly_equal_vertices == soup.positions.size() - mesh.positions.size());
            CHECK(clean.report.fillings.empty());
        }
}

TEST_CASE("what is farther apart than rounding stays apart") {
    const SurfaceMesh soup = soup_of(icosphere(2), 1e-3, 1);
    CHECK(welded(soup) < soup.positions.size() / 100);
}

TEST_CASE("the two sides of a wall stay apart, however thin it is") {
    for (const double height : {1e-2, 1e-4, 1e-6, 1e-9, 1e-12}) {
        CAPTURE(height);
        CHECK(welded(open_box(height)) == 0);
    }
}

TEST_CASE("vertices inside a surface are left alone, though another surface is a hair away") {
    const SurfaceMesh ball = icosphere(2);
    const SurfaceMesh shell = moved(ball, [](const glm::dvec3& p) { return (1 + 1e-7) * p; });
    CHECK(welded(joined(ball, shell)) == 0);
}

TEST_CASE("many vertices with short edges in one small place take no more than their time") {
    SurfaceMesh mesh = moved(soup_of(icosphere(5), 0, 1), [](const glm::dvec3& p) { return 1e-6 * p; });
    const auto first = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    mesh.triangles.push_back({first, first + 1, first + 2});
    std::size_t steps = 0;
    const Progress count = [&](std::string_view, double) { return ++steps < 1'000'000; };
    ProgressMeter meter(count);
    weld_nearby(mesh.positions, mesh.triangles, meter);
    CHECK(steps > 0);
}
