#include "hierarchy/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

TEST_CASE("area, volume, angle and box of the octahedron") {
    const std::vector<glm::vec3> points = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                           {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    const RootComplex roots = octahedron();
    const Measures measures = measure(roots.triangles(), points);
    CHECK(measures.area == doctest::Approx(4 * std::sqrt(3.0)));
    CHECK(measures.volume == doctest::Approx(4.0 / 3.0));
    CHECK(measures.min_angle == doctest::Approx(60));
    CHECK(bounding_box(points).diagonal() == doctest::Approx(2 * std::sqrt(3.0)));
}

TEST_CASE("an extent has the box and the smallest sphere about its center, in parts or whole") {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        std::vector<glm::vec3> all(1 + random.below(20));
        for (glm::vec3& p : all)
            for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<float>(10 * random.unit() - 5);
        const Extent extent = extent_of(all);
        CHECK(extent.box.min == bounding_box(all).min);
        CHECK(extent.box.max == bounding_box(all).max);
        float farthest = 0;
        for (const glm::vec3& p : all) farthest = std::max(farthest, glm::distance(p, extent.box.center()));
        CHECK(extent.radius == farthest);
        const std::span<const glm::vec3> whole(all);
        const std::size_t cut = random.below(all.size());
        const std::array parts{whole.first(cut), whole.subspan(cut)};
        CHECK(extent_of(parts).box.min == extent.box.min);
        CHECK(extent_of(parts).box.max == extent.box.max);
        CHECK(extent_of(parts).radius == extent.radius);
    }
}

TEST_CASE(
    "the Euler number of an indexed mesh is that of its complex; closed and open meshes are distinguished") {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_roots(random);
        REQUIRE(euler_number(roots.triangles()) == roots.euler_number());
        REQUIRE(is_closed_manifold(roots.triangles()) == (roots.boundary_edge_count() == 0));
    }
    for (unsigned genus = 0; genus <= 3; ++genus)
        CHECK(plate(genus).euler_number() == 2 - 2 * static_cast<int>(genus));
    CHECK(torus(3, 4).euler_number() == 0);
    CHECK(sheet(2, 3).euler_number() == 1);
}

TEST_CASE("inconsistent orientation and an edge of four triangles are not a closed manifold") {
    CHECK_FALSE(is_closed_manifold(std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}}));
    std::vector<Triangle> two_tetrahedra = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}};
    CHECK(is_closed_manifold(two_tetrahedra));
    for (const Triangle& triangle : std::vector<Triangle>{{0, 1, 4}, {0, 4, 5}, {0, 5, 1}, {5, 4, 1}})
        two_tetrahedra.push_back(triangle);
    CHECK_FALSE(is_closed_manifold(two_tetrahedra));
}
