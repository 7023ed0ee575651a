#include "hierarchy/adaptive_mesh.h"

#include <algorithm>
#include <set>

#include "trials.h"
#include <doctest/doctest.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "hierarchy/literal.h"
#include "hierarchy/marking.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// The nodes of the present leaves, in preorder.
std::vector<Node> nodes_of(const AdaptiveMesh& mesh) {
    const Hierarchy hierarchy = mesh.freeze();
    return leaf_nodes(bisected_nodes(hierarchy), hierarchy.roots.triangle_count());
}

}  // namespace

TEST_CASE("every refinement conforms, keeps the mesh's own invariants and freezes soundly, 10,000 meshes") {
    std::size_t leaves = 0;
    for (std::uint64_t seed = 1; seed <= trials(10000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const auto marking = static_cast<Marking>(random.below(3));
        const RootComplex roots = marked(random_roots(random), marking, random);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        InfiniteComplex complex(roots);
        for (unsigned round = 0; round < 4; ++round) {
            refine_at_random(mesh, random, 1, 80);
            REQUIRE(mesh.violations() == std::vector<std::string>{});
            REQUIRE(check(mesh.freeze()) == std::vector<std::string>{});
        }
        const unsigned difference = is_compatibly_marked(roots) ? 1 : 2;
        REQUIRE(triangulation_violations(complex, nodes_of(mesh), difference) == std::vector<std::string>{});
        leaves += mesh.leaf_count();
    }
    CHECK(leaves > trials(200000));
}

TEST_CASE("refinement gives exactly the result of algorithm (A) in passes") {
    for (std::uint64_t seed = 1; seed <= trials(1500); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = marked(random_roots(random), static_cast<Marking>(random.below(3)), random);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        InfiniteComplex complex(roots);
        for (unsigned round = 0; round < 4 && mesh.leaf_count() < 60; ++round) {
            const std::vector<Node> before = nodes_of(mesh);
            const std::vector<Index> order = mesh.preorder();
            std::vector<Index> marks;
            std::set<Node> marked_nodes;
            for (std::size_t n = 0; n < order.size(); ++n) {
                if (!random.chance(0.2)) continue;
                marks.push_back(order[n]);
                marked_nodes.insert(before[n]);
            }
            const std::set<Node> expected = rivara(complex, {before.begin(), before.end()}, marked_nodes);
            mesh.refine(marks);
            const std::vector<Node> after = nodes_of(mesh);
            REQUIRE(std::set<Node>(after.begin(), after.end()) == expected);
        }
    }
}

TEST_CASE(
    "leaves_added_by returns the number of leaves that refine adds, and refine lists the changed leaves") {
    for (std::uint64_t seed = 1; seed <= trials(2000); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const RootComplex roots = random_roots(random);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        for (unsigned step = 0; step < 20; ++step) {
            const auto leaf = static_cast<Index>(random.below(mesh.leaf_count()));
            const Index count = mesh.leaf_count();
            std::vector<std::pair<Triangle, unsigned>> before;
            for (Index n = 0; n < count; ++n) before.emplace_back(mesh.vertices(n), mesh.level(n));
            const Index added = mesh.leaves_added_by(leaf);
            std::vector<Index> changed;
            mesh.refine(std::span(&leaf, 1), &changed);
            REQUIRE(mesh.leaf_count() == count + added);
            REQUIRE(mesh.level(leaf) > before[leaf].second);
            const std::set<Index> reported(changed.begin(), changed.end());
            for (Index n = 0; n < mesh.leaf_count(); ++n) {
                const bool same = n < count && before[n] == std::pair(mesh.vertices(n), mesh.level(n));
                REQUIRE(reported.contains(n) == !same);
            }
        }
    }
}

TEST_CASE("a cycle of leaves that wait for each other is refined as one step") {
    for (Index spokes = 3; spokes <= 9; ++spokes) {
        CAPTURE(spokes);
        const RootComplex roots = pinwheel(spokes);
        Random random(spokes);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        const Index first = 0;
        CHECK(mesh.leaves_added_by(first) == 2 * spokes);
        mesh.refine(std::span(&first, 1));
        CHECK(mesh.leaf_count() == 3 * spokes);
        for (unsigned round = 0; round < 6; ++round) {
            std::vector<Index> all(mesh.leaf_count());
            for (Index leaf = 0; leaf < mesh.leaf_count(); ++leaf) all[leaf] = leaf;
            mesh.refine(all);
            REQUIRE(mesh.violations() == std::vector<std::string>{});
            REQUIRE(check(mesh.freeze()) == std::vector<std::string>{});
        }
    }
}

TEST_CASE("a leaf that is marked twice, or reached by closure before, is bisected once") {
    AdaptiveMesh mesh(sheet(1, 1), std::vector<glm::vec3>(4, glm::vec3(0)));
    mesh.refine(std::vector<Index>{0, 1, 0});
    CHECK(mesh.leaf_count() == 4);
}

TEST_CASE("refine may append to the list of its own marks") {
    AdaptiveMesh mesh(octahedron(), std::vector<glm::vec3>(6, glm::vec3(0)));
    std::vector<Index> changed = {0};
    for (unsigned round = 0; round < 6; ++round) mesh.refine(changed, &changed);
    CHECK(check(mesh.freeze()).empty());
    CHECK(mesh.leaf_count() > 64);
}

TEST_CASE(
    "refinement stops with an error before a leaf is deeper than 64 levels, and the mesh still conforms") {
    for (const Marking marking : {Marking::random, Marking::compatible}) {
        Random random(7);
        const RootComplex roots = marked(octahedron(), marking, random);
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()));
        const auto deepest = [&] {
            Index best = 0;
            for (Index leaf = 0; leaf < mesh.leaf_count(); ++leaf)
                if (mesh.level(leaf) > mesh.level(best)) best = leaf;
            return best;
        };
        CHECK_THROWS_AS(
            for (unsigned n = 0; n < 200; ++n) {
                const Index leaf = deepest();
                mesh.refine(std::span(&leaf, 1));
            },
            InputError);
        CHECK(mesh.level(deepest()) >= max_level - 1);
        CHECK(mesh.level(deepest()) <= max_level);
        CHECK(mesh.violations().empty());
        CHECK(check(mesh.freeze()).empty());
    }
}

TEST_CASE("the midpoint rule is called once per new vertex, in the order of indices") {
    std::vector<std::pair<Index, Index>> asked;
    AdaptiveMesh mesh(octahedron(), std::vector<glm::vec3>(6, glm::vec3(0)),
                      [&](Index a, Index b, Index midpoint) {
                          CHECK(midpoint == 6 + asked.size());
                          asked.emplace_back(a, b);
                          return glm::vec3(static_cast<float>(asked.size()), 0, 0);
                      });
    mesh.refine(std::vector<Index>{0, 3, 5});
    REQUIRE(asked.size() == mesh.vertex_count() - 6);
    for (std::size_t n = 0; n < asked.size(); ++n) {
        CHECK(asked[n].first < asked[n].second);
        CHECK(mesh.positions()[6 + n].x == static_cast<float>(n + 1));
    }
}
