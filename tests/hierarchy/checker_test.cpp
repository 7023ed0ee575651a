#include "hierarchy/checker.h"

#include <limits>

#include "messages.h"
#include "trials.h"
#include <doctest/doctest.h>

#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// Two triangles that share the edge (1, 2), which is the refinement edge of both. Both are bisected there,
/// with vertex 4 in the middle.
Hierarchy bisected_square() {
    const std::vector<glm::vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    AdaptiveMesh mesh(sheet(1, 1), corners);
    mesh.refine(std::vector<Index>{0});
    return mesh.freeze();
}

}  // namespace

TEST_CASE("any single change of a midpoint, a bit, a position or a size is found, 10,000 hierarchies") {
    for_random_families(10000, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        Random random(family.seed * 31);
        const Hierarchy& sound = family.keys[0];
        REQUIRE(check(sound) == std::vector<std::string>{});

        Hierarchy damaged = sound;
        damaged.positions[random.below(damaged.positions.size())].y = std::numeric_limits<float>::quiet_NaN();
        REQUIRE_FALSE(check(damaged).empty());

        damaged = sound;
        const std::size_t bit = random.below(64 * damaged.bits.size());
        damaged.bits[bit / 64] ^= std::uint64_t{1} << (bit % 64);
        REQUIRE_FALSE(check(damaged).empty());

        damaged = sound;
        damaged.positions.emplace_back(0.0F);
        REQUIRE_FALSE(check(damaged).empty());

        damaged = sound;
        damaged.midpoints.push_back(sound.roots.vertex_count());
        REQUIRE_FALSE(check(damaged).empty());

        if (sound.midpoints.empty()) return;
        damaged = sound;
        Index& midpoint = damaged.midpoints[random.below(damaged.midpoints.size())];
        midpoint = static_cast<Index>((midpoint + 1 + random.below(damaged.positions.size())) %
                                      (damaged.positions.size() + 1));
        if (damaged.midpoints != sound.midpoints) REQUIRE_FALSE(check(damaged).empty());

        damaged = sound;
        std::swap(damaged.midpoints[random.below(damaged.midpoints.size())],
                  damaged.midpoints[random.below(damaged.midpoints.size())]);
        if (damaged.midpoints != sound.midpoints) REQUIRE_FALSE(check(damaged).empty());
    });
}

TEST_CASE("arbitrary bits and midpoints never make the checker read out of bounds or loop") {
    for (std::uint64_t seed = 1; seed <= trials(20000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Hierarchy hierarchy{octahedron(), {}, {}, {}};
        hierarchy.midpoints.resize(random.below(100));
        hierarchy.positions.resize(6 + random.below(80));
        for (Index& midpoint : hierarchy.midpoints)
            midpoint = static_cast<Index>(random.below(hierarchy.positions.size() + 2));
        hierarchy.bits.resize((hierarchy.node_count() + 63) / 64);
        for (std::uint64_t& word : hierarchy.bits) word = random.below(~std::size_t{0});
        REQUIRE_FALSE(check(hierarchy).empty());
    }
}

TEST_CASE("a hanging node is named with its edge") {
    // Root 1 loses its bisection, so the midpoint becomes a hanging node of it.
    Hierarchy hierarchy = bisected_square();
    REQUIRE(check(hierarchy).empty());
    hierarchy.bits = {0b0001};
    hierarchy.midpoints.pop_back();
    CHECK(mentions(check(hierarchy), "vertex 4 bisects edge (1, 2) on one side only"));
}

TEST_CASE("two vertices on one edge are found") {
    Hierarchy hierarchy = bisected_square();
    hierarchy.midpoints[1] = 5;
    hierarchy.positions.emplace_back(0.0F);
    CHECK(mentions(check(hierarchy), "on one side only"));
}

TEST_CASE("missing and surplus data are named") {
    Hierarchy hierarchy = bisected_square();
    hierarchy.positions.emplace_back(0.0F);
    CHECK(mentions(check(hierarchy), "vertex 5 is no midpoint"));
    hierarchy = bisected_square();
    hierarchy.bits[0] |= std::uint64_t{1} << 63;
    CHECK(mentions(check(hierarchy), "bits after the last node"));
    hierarchy = bisected_square();
    hierarchy.bits.push_back(0);
    CHECK(mentions(check(hierarchy), "words of preorder bits"));
    hierarchy = bisected_square();
    hierarchy.positions[2].x = std::numeric_limits<float>::infinity();
    CHECK(mentions(check(hierarchy), "vertex 2 is at (inf"));
    CHECK(mentions(check(Hierarchy{}), "no root triangles"));
}

TEST_CASE("a tree deeper than 64 levels is rejected") {
    // A single triangle whose first child is bisected again and again. Every midpoint lies on the boundary or
    // is visited twice.
    Hierarchy hierarchy{RootComplex(3, {{0, 1, 2}}), {}, {}, {}};
    for (Index n = 0; n < 70; ++n) hierarchy.midpoints.push_back(3 + n);
    hierarchy.positions.assign(73, glm::vec3(0));
    hierarchy.bits.assign((hierarchy.node_count() + 63) / 64, ~std::uint64_t{0});
    CHECK(mentions(check(hierarchy), "at most 64 levels deep"));
}

TEST_CASE("the checker lists no more violations than requested") {
    Hierarchy hierarchy = bisected_square();
    for (glm::vec3& position : hierarchy.positions) position.x = std::numeric_limits<float>::quiet_NaN();
    CHECK(check(hierarchy).size() == 5);
    CHECK(check(hierarchy, 2).size() == 2);
}

TEST_CASE("constraints (B) name the key and the root that differs") {
    const Hierarchy key = bisected_square();
    Hierarchy other = key;
    const std::vector<const Hierarchy*> keys = {&key, &key, &other};
    CHECK(check_constraints(keys).empty());
    other = unrefined(RootComplex(4, {{0, 1, 2}, {2, 1, 3}}), std::vector<glm::vec3>(4));
    CHECK(mentions(check_constraints(keys),
                   "key 2 has different roots from key 0: root triangle 1 is (2, 1, 3), expected (3, 2, 1)"));
    other = unrefined(octahedron(), std::vector<glm::vec3>(6));
    CHECK(mentions(check_constraints(keys), "8 root triangles over 6 vertices, expected 2 over 4"));
}
