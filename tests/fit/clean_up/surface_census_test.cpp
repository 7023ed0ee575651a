// The figures of meshes whose figures are known.
#include "fit/clean_up/surface_census.h"

#include <utility>

#include <doctest/doctest.h>

#include "fit/closed_meshes.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

SurfaceMesh box(const glm::dvec3& sides) {
    SurfaceMesh cube;
    for (int i = 0; i < 8; ++i) cube.positions.emplace_back(sides * glm::dvec3(i & 1, (i >> 1) & 1, i >> 2));
    cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return cube;
}

SurfaceMesh turned_over(SurfaceMesh mesh) {
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

}  // namespace

TEST_CASE("a box has its area and volume, one part, no opening and no handle, inside out as well") {
    for (const SurfaceMesh& mesh : {box({1, 2, 3}), turned_over(box({1, 2, 3}))}) {
        const SurfaceCensus census = census_of(mesh);
        CHECK(census.vertices == 8);
        CHECK(census.triangles == 12);
        CHECK(census.area == doctest::Approx(22));
        CHECK(census.volume.value() == doctest::Approx(6));
        CHECK(census.parts == 1);
        CHECK(census.openings == 0);
        CHECK(census.handles == 0);
        CHECK(census.crowded_edges == 0);
    }
}

TEST_CASE("handles and openings are counted over all parts") {
    CHECK(census_of(torus(12, 8)).handles == 1);
    const SurfaceCensus two = census_of(joined(
        torus(12, 8), moved(torus(8, 6), [](const glm::dvec3& p) { return p + glm::dvec3(10, 0, 0); })));
    CHECK(two.parts == 2);
    CHECK(two.handles == 2);
    SurfaceMesh open = torus(12, 8);
    open.triangles.pop_back();
    open.triangles.erase(open.triangles.begin() + 90);
    const SurfaceCensus census = census_of(open);
    CHECK(census.openings == 2);
    CHECK(census.handles == 1);
    CHECK_FALSE(census.volume.has_value());
    CHECK(census_of(sheet(4)).openings == 1);
    CHECK(census_of(sheet(4)).handles == 0);
}

TEST_CASE("the wall of a cavity counts against the volume, unless triangles do not agree anyway") {
    const SurfaceMesh inner = moved(box({1, 1, 1}), [](const glm::dvec3& p) { return p + 1.0; });
    CHECK(census_of(joined(box({3, 3, 3}), turned_over(inner))).volume.value() == doctest::Approx(26));
    SurfaceMesh muddled = box({3, 3, 3});
    std::swap(muddled.triangles[4][0], muddled.triangles[4][1]);
    CHECK(census_of(muddled).volume.value() == doctest::Approx(27));
}

TEST_CASE("what is welded and removed is counted") {
    SurfaceMesh mesh = box({1, 1, 1});
    mesh.positions.push_back(mesh.positions[3]);
    mesh.triangles[1][2] = 8;
    mesh.triangles.push_back(mesh.triangles[5]);
    mesh.triangles.push_back({0, 0, 1});
    const SurfaceCensus census = census_of(mesh);
    CHECK(census.welded_vertices == 1);
    CHECK(census.removed_triangles == 2);
    CHECK(census.volume.value() == doctest::Approx(1));
    CHECK_FALSE(census_as_it_is(mesh).volume.has_value());
}
