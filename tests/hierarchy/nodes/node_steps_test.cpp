#include "hierarchy/nodes/node_steps.h"

#include <map>
#include <optional>
#include <set>
#include <utility>

#include <doctest/doctest.h>

#include "hierarchy/literal.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

NodePath to_path(const Node& node) {
    return {static_cast<Index>(node.root), node.level, node.path};
}

/// The union of \p family: every node, and by edge, in its direction, the deepest node that has the edge.
struct LiteralUnion {
    std::set<Node> bisected;
    std::set<Node> nodes;
    std::map<std::pair<Index, Index>, Node> deepest;
    InfiniteComplex complex;

    explicit LiteralUnion(const RandomFamily& family) : complex(family.roots) {
        for (const Hierarchy& key : family.keys) bisected.merge(bisected_nodes(key));
        for (const Node& leaf : leaf_nodes(bisected, family.roots.triangle_count())) nodes.insert(leaf);
        nodes.insert(bisected.begin(), bisected.end());
        for (const Node& node : nodes) {
            const Triangle vertices = complex.triangle(node);
            for (unsigned side = 0; side < 3; ++side) {
                const auto [place, is_new] = deepest.try_emplace(edge(vertices, side), node);
                if (!is_new && node.level > place->second.level) place->second = node;
            }
        }
    }

    static std::pair<Index, Index> edge(const Triangle& vertices, unsigned side) {
        return {vertices[(side + 1) % 3], vertices[(side + 2) % 3]};
    }

    std::optional<NodePath> across(const Node& node, unsigned side) {
        const auto [a, b] = edge(complex.triangle(node), side);
        const auto found = deepest.find({b, a});
        return found == deepest.end() ? std::nullopt : std::optional(to_path(found->second));
    }
};

}  // namespace

TEST_CASE("every step from every node of the union agrees with the literal union") {
    for_random_families(1500, 2, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const NodeIndex first(family.keys[0]);
        const NodeIndex second(family.keys[1]);
        const std::array<const NodeIndex*, 2> keys = {&first, &second};
        LiteralUnion united(family);
        for (const Node& node : united.nodes) {
            const NodePath path = to_path(node);
            const bool is_bisected = united.bisected.contains(node);
            REQUIRE(union_state(keys, path) == (is_bisected ? NodeState::bisected : NodeState::leaf));
            const auto step = [&](NodeStep way) { return stepped(keys, path, way); };
            if (node.level == 0) {
                REQUIRE(!step(NodeStep::parent));
                REQUIRE(!step(NodeStep::sibling));
            } else {
                const Node parent = node.parent();
                const unsigned which = node == parent.child(0) ? 0 : 1;
                REQUIRE(step(NodeStep::parent) == to_path(parent));
                REQUIRE(step(NodeStep::sibling) == to_path(parent.child(1 - which)));
            }
            REQUIRE(step(NodeStep::first_child).has_value() == is_bisected);
            if (is_bisected) {
                REQUIRE(step(NodeStep::first_child) == to_path(node.child(0)));
                REQUIRE(step(NodeStep::second_child) == to_path(node.child(1)));
            }
            REQUIRE(step(NodeStep::across_first) == united.across(node, 0));
            REQUIRE(step(NodeStep::across_second) == united.across(node, 1));
            REQUIRE(step(NodeStep::across_third) == united.across(node, 2));
        }
    });
}

TEST_CASE("steps from a node below all keys lead up, and never out of the union") {
    for_random_families(300, 2, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const NodeIndex index(family.keys[0]);
        const std::array<const NodeIndex*, 1> keys = {&index};
        for (const Node& leaf : leaf_nodes(bisected_nodes(family.keys[0]), family.roots.triangle_count())) {
            const NodePath below = child_of(child_of(to_path(leaf), 1), 0);
            REQUIRE(union_state(keys, below) == NodeState::inside_leaf);
            for (const NodeStep step : all_node_steps) {
                const auto to = stepped(keys, below, step);
                REQUIRE((!to || *to == parent_of(below) || union_state(keys, *to) != NodeState::inside_leaf));
            }
        }
    });
}
