#include "hierarchy/nodes/node_index.h"

#include <map>
#include <set>
#include <utility>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/literal.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

NodePath path_to(const Node& node) {
    return {static_cast<Index>(node.root), node.level, node.path};
}

bool is_below(const Node& node, const Node& ancestor) {
    const std::uint64_t turns = ancestor.level == 0 ? 0 : ~std::uint64_t{0} >> (64 - ancestor.level);
    return node.root == ancestor.root && node.level >= ancestor.level && (node.path & turns) == ancestor.path;
}

/// The leaves of \p key in preorder, and the nodes that it bisects.
struct LiteralKey {
    std::set<Node> bisected;
    std::vector<Node> leaves;
    explicit LiteralKey(const Hierarchy& key)
        : bisected(bisected_nodes(key)), leaves(leaf_nodes(bisected, key.roots.triangle_count())) {}
};

}  // namespace

TEST_CASE("state, leaves and vertices of every node agree with the literal forest") {
    for_random_families(1500, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const LiteralKey key(family.keys[0]);
        const NodeIndex index(family.keys[0]);
        InfiniteComplex complex(family.roots);
        REQUIRE(index.leaf_count() == key.leaves.size());
        std::map<Index, Index> names;  // of the key's vertices in the infinite complex
        const auto check_vertices = [&](const Node& node) {
            const Triangle vertices = index.vertices(path_to(node));
            const Triangle expected = complex.triangle(node);
            for (std::size_t corner = 0; corner < 3; ++corner)
                REQUIRE(names.try_emplace(vertices[corner], expected[corner]).first->second ==
                        expected[corner]);
        };
        for (std::size_t leaf = 0; leaf < key.leaves.size(); ++leaf) {
            const Node& node = key.leaves[leaf];
            REQUIRE(index.state(path_to(node)) == NodeState::leaf);
            REQUIRE(index.leaves(path_to(node)) == LeafRange{leaf, leaf + 1});
            REQUIRE(index.level(leaf) == node.level);
            for (const unsigned which : {0U, 1U}) {
                REQUIRE(index.state(path_to(node.child(which))) == NodeState::inside_leaf);
                REQUIRE(index.leaves(path_to(node.child(which).child(1))) == LeafRange{leaf, leaf + 1});
            }
            check_vertices(node);
        }
        for (const Node& node : key.bisected) {
            REQUIRE(index.state(path_to(node)) == NodeState::bisected);
            const LeafRange range = index.leaves(path_to(node));
            for (std::size_t leaf = 0; leaf < key.leaves.size(); ++leaf)
                REQUIRE((leaf >= range.begin && leaf < range.end) == is_below(key.leaves[leaf], node));
            check_vertices(node);
        }
    });
}

TEST_CASE("the corners of a node of the union have in each key the places of the union's streams") {
    for_random_families(1500, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        std::vector<unsigned> levels;
        for (const LeafTag tag : mesh.tags) levels.push_back(tag.level());
        const std::vector<Node> nodes = nodes_of_levels(levels);
        for (std::size_t key = 0; key < family.keys.size(); ++key) {
            const NodeIndex index(family.keys[key]);
            for (std::size_t leaf = 0; leaf < nodes.size(); ++leaf) {
                const auto corners = index.corners(path_to(nodes[leaf]));
                for (std::size_t corner = 0; corner < 3; ++corner)
                    REQUIRE(glm::distance(surface_position(corners[corner], family.keys[key].positions),
                                          mesh.positions[key][mesh.triangles[leaf][corner]]) < 1e-5F);
            }
        }
    });
}

TEST_CASE("the boundary of a node is that of its leaves, from corner to corner") {
    using Edge = std::pair<Index, Index>;
    for_random_families(600, 2, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        const NodeIndex index(mesh);
        std::set<Node> bisected;
        for (const Hierarchy& key : family.keys) bisected.merge(bisected_nodes(key));
        for (const Node& node : bisected) {
            std::set<Edge> inner, edges;
            const LeafRange range = index.leaves(path_to(node));
            for (std::size_t leaf = range.begin; leaf < range.end; ++leaf)
                for (std::size_t corner = 0; corner < 3; ++corner)
                    inner.emplace(mesh.triangles[leaf][corner], mesh.triangles[leaf][(corner + 1) % 3]);
            for (const auto& [a, b] : inner)
                if (!inner.contains({b, a})) edges.emplace(a, b);
            const Triangle corners = index.vertices(path_to(node));
            const auto parts = index.boundary(path_to(node));
            std::set<Edge> found;
            for (std::size_t side = 0; side < 3; ++side) {
                REQUIRE(parts[side].front().vertices[0] == corners[(side + 1) % 3]);
                REQUIRE(parts[side].back().vertices[0] == corners[(side + 2) % 3]);
                for (std::size_t point = 1; point < parts[side].size(); ++point)
                    found.emplace(parts[side][point - 1].vertices[0], parts[side][point].vertices[0]);
            }
            REQUIRE(found == edges);
        }
    });
}

TEST_CASE("a path of 64 levels is found to its end") {
    const RootComplex root(3, {{0, 1, 2}});
    UnionMesh mesh;
    mesh.roots = root;
    mesh.tags.resize(65);
    mesh.triangles.resize(65);
    mesh.tags[0] = LeafTag(64, 0, {0, 0, 0});
    for (unsigned level = 64; level > 0; --level) mesh.tags[65 - level] = LeafTag(level, 0, {0, 0, 0});
    for (Triangle& triangle : mesh.triangles) triangle = {0, 1, 2};
    const NodeIndex index(mesh);
    CHECK(index.state({0, 64, 0}) == NodeState::leaf);
    CHECK(index.leaves({0, 63, 0}) == LeafRange{0, 2});
    CHECK(index.state({0, 64, std::uint64_t{1} << 63}) == NodeState::leaf);
    CHECK(index.leaves({0, 0, 0}) == LeafRange{0, 65});
    CHECK(index.state({0, 64, 1}) == NodeState::inside_leaf);
    CHECK(index.leaves({0, 64, 1}) == LeafRange{64, 65});
}
