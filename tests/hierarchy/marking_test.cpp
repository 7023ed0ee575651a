#include "hierarchy/marking.h"

#include <algorithm>

#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// Whether \p a and \p b have the same triangles up to rotation of their triples.
bool differ_by_marking_only(const RootComplex& a, const RootComplex& b) {
    if (a.vertex_count() != b.vertex_count() || a.triangle_count() != b.triangle_count()) return false;
    for (Index t = 0; t < a.triangle_count(); ++t) {
        Triangle triangle = b.triangles()[t];
        bool same = false;
        for (int turn = 0; turn < 3; ++turn) {
            std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
            same = same || triangle == a.triangles()[t];
        }
        if (!same) return false;
    }
    return true;
}

}  // namespace

TEST_CASE(
    "a compatible marking exists on every surface, closed and open, and changes nothing but the marking") {
    for (std::uint64_t seed = 1; seed <= trials(3000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_roots(random);
        const RootComplex marked = mark_compatibly(roots);
        REQUIRE(is_compatibly_marked(marked));
        REQUIRE(differ_by_marking_only(roots, marked));
    }
}

TEST_CASE("marking by the longest edge puts the longest edge opposite the first vertex") {
    for (std::uint64_t seed = 1; seed <= trials(1000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_roots(random);
        const std::vector<glm::vec3> points = random_points(random, roots.vertex_count());
        const RootComplex marked = mark_longest_edges(roots, points);
        REQUIRE(differ_by_marking_only(roots, marked));
        for (const auto& [a, b, c] : marked.triangles()) {
            REQUIRE(glm::distance(points[b], points[c]) >= glm::distance(points[a], points[b]));
            REQUIRE(glm::distance(points[b], points[c]) >= glm::distance(points[a], points[c]));
        }
    }
}

TEST_CASE("an incompatible marking is distinguished from a compatible one") {
    CHECK(is_compatibly_marked(sheet(1, 1)));
    CHECK_FALSE(is_compatibly_marked(RootComplex(4, {{0, 1, 2}, {2, 1, 3}})));
}
