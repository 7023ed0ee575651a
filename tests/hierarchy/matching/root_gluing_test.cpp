#include "hierarchy/matching/root_gluing.h"

#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

TEST_CASE("side 3 t + k is the edge opposite corner k of triangle t, and has the same edge across it") {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_roots(random);
        const RootGluing gluing = gluing_of(roots);
        REQUIRE(gluing.across.size() == 3 * std::size_t{roots.triangle_count()});
        for (Index t = 0; t < roots.triangle_count(); ++t)
            for (Index k = 0; k < 3; ++k) {
                const Index side = 3 * t + k;
                const Triangle& corners = roots.triangles()[t];
                REQUIRE(gluing.apex(side) == corners[k]);
                const Index across = gluing.across[side];
                REQUIRE((across == no_index) == (roots.neighbors()[t][k] == no_index));
                if (across == no_index) continue;
                REQUIRE(across / 3 == roots.neighbors()[t][k]);
                REQUIRE(gluing.across[across] == side);
                const Triangle& others = roots.triangles()[across / 3];
                const Index l = across % 3;
                REQUIRE(corners[(k + 1) % 3] == others[(l + 2) % 3]);
                REQUIRE(corners[(k + 2) % 3] == others[(l + 1) % 3]);
            }
    }
}

TEST_CASE("turning a side goes round its triangle") {
    CHECK(turned(4, 0) == 4);
    CHECK(turned(4, 1) == 5);
    CHECK(turned(4, 2) == 3);
    CHECK(turned(5, 1) == 3);
}

TEST_CASE("components are listed by their lowest triangle, and cover all triangles once") {
    const RootComplex roots = side_by_side(octahedron(), torus(3, 4));
    const RootGluing gluing = gluing_of(roots);
    REQUIRE(gluing.component_count() == 2);
    CHECK(gluing.component(0).size() == 8);
    CHECK(gluing.component(1).size() == 24);
    CHECK(gluing.component(0).front() == 0);
    CHECK(gluing.component(1).front() == 8);
    std::vector<Index> sorted = gluing.order;
    std::sort(sorted.begin(), sorted.end());
    for (Index t = 0; t < roots.triangle_count(); ++t) CHECK(sorted[t] == t);
}
