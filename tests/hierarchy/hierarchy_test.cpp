#include "hierarchy/hierarchy.h"

#include <doctest/doctest.h>

#include "hierarchy/checker.h"
#include "hierarchy/literal.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

TEST_CASE("the children of a triangle are those of the paper's figure 4, and merging them restores it") {
    const Triangle parent = {1, 2, 3};
    const auto children = bisect(parent, 9);
    CHECK(children[0] == Triangle{9, 3, 1});
    CHECK(children[1] == Triangle{9, 1, 2});
    CHECK(merge(children[0], children[1]) == parent);
}

TEST_CASE("freezing the leaves of a hierarchy gives the hierarchy, 10,000 hierarchies") {
    for_random_families(10000, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Hierarchy& key = family.keys[0];
        const std::vector<Leaf> leaves = leaves_of(key);
        REQUIRE(leaves.size() == key.leaf_count());
        const Hierarchy again = hierarchy_from_leaves(key.roots, leaves, key.positions);
        REQUIRE(again.roots == key.roots);
        REQUIRE(again.bits == key.bits);
        REQUIRE(again.midpoints == key.midpoints);
        REQUIRE(again.positions == key.positions);
    });
}

TEST_CASE("leaves_of returns the leaves of the forest, with their triangles, in preorder") {
    for_random_families(2000, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Hierarchy& key = family.keys[0];
        const std::vector<Leaf> leaves = leaves_of(key);
        const std::vector<Node> nodes = leaf_nodes(bisected_nodes(key), key.roots.triangle_count());
        REQUIRE(leaves.size() == nodes.size());
        InfiniteComplex complex(key.roots);
        std::map<Index, Index> names;  // from vertices of the key to those of the complex
        for (std::size_t n = 0; n < leaves.size(); ++n) {
            REQUIRE(leaves[n].level == nodes[n].level);
            const Triangle expected = complex.triangle(nodes[n]);
            for (std::size_t k = 0; k < 3; ++k)
                REQUIRE(names.try_emplace(leaves[n].vertices[k], expected[k]).first->second == expected[k]);
        }
    });
}

TEST_CASE("a hierarchy of 5,000 leaves takes at most 10.5 bytes per leaf") {
    AdaptiveMesh mesh(octahedron(), std::vector<glm::vec3>(6));
    while (mesh.leaf_count() < 5000) {
        std::vector<Index> all = mesh.preorder();
        mesh.refine(all);
    }
    const Hierarchy hierarchy = mesh.freeze();
    CHECK(static_cast<double>(hierarchy.byte_count()) / static_cast<double>(hierarchy.leaf_count()) <= 10.5);
}

TEST_CASE("the unrefined roots are a sound hierarchy without bisections") {
    const Hierarchy hierarchy = unrefined(torus(3, 4), std::vector<glm::vec3>(12));
    CHECK(check(hierarchy).empty());
    CHECK(hierarchy.leaf_count() == 24);
    CHECK(leaves_of(hierarchy)[5].vertices == hierarchy.roots.triangles()[5]);
}
