#include "shapes/icosahedron.h"

#include <algorithm>
#include <set>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/marking.h"
#include "hierarchy/measure.h"

using namespace interleaf;

namespace {

/// The number of the vertex at \p position; there is one.
Index vertex_at(const Hierarchy& key, const glm::vec3& position) {
    const auto vertex = std::find_if(key.positions.begin(), key.positions.end(),
                                     [&](const glm::vec3& p) { return glm::distance(p, position) < 1e-6F; });
    REQUIRE(vertex != key.positions.end());
    return static_cast<Index>(vertex - key.positions.begin());
}

}  // namespace

TEST_CASE("the icosahedron is a sound key of 20 equilateral triangles on the unit sphere, facing out") {
    const Hierarchy key = icosahedron();
    CHECK(check(key).empty());
    CHECK(key.leaf_count() == 20);
    CHECK(key.vertex_count() == 12);
    CHECK(is_closed_manifold(key.roots.triangles()));
    CHECK(key.roots.euler_number() == 2);
    for (const glm::vec3& position : key.positions) CHECK(glm::length(position) == doctest::Approx(1));
    const Measures measures = measure(key.roots.triangles(), key.positions);
    CHECK(measures.min_angle == doctest::Approx(60).epsilon(1e-5));
    CHECK(measures.volume == doctest::Approx(2.53615).epsilon(1e-5));
}

TEST_CASE("the icosahedron is compatibly marked") {
    CHECK(is_compatibly_marked(icosahedron().roots));
}

TEST_CASE("half turns about the axes keep the icosahedron's triangles and their marking") {
    const Hierarchy key = icosahedron();
    // A triangle with its marking: the first vertex, then the refinement edge.
    const std::set<Triangle> triangles(key.roots.triangles().begin(), key.roots.triangles().end());
    for (const glm::vec3 turn : {glm::vec3(1, -1, -1), glm::vec3(-1, 1, -1), glm::vec3(-1, -1, 1)}) {
        for (const Triangle& triangle : triangles) {
            Triangle turned{};
            for (unsigned i = 0; i < 3; ++i) turned[i] = vertex_at(key, turn * key.positions[triangle[i]]);
            CHECK(triangles.count(turned) == 1);
        }
    }
}
