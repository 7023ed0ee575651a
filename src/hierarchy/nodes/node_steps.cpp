#include "hierarchy/nodes/node_steps.h"

#include <algorithm>

namespace interleaf {

namespace {

std::optional<NodePath> neighbor_across(std::span<const NodeIndex* const> keys, const NodeSide& side) {
    std::optional<NodeSide> beyond = side_across(keys.front()->roots(), side);
    if (!beyond) return std::nullopt;
    if (beyond->side != refinement_side && union_state(keys, beyond->node) == NodeState::bisected)
        beyond = child_with_side(*beyond);
    if (union_state(keys, beyond->node) == NodeState::inside_leaf) return std::nullopt;
    return beyond->node;
}

}  // namespace

NodeState union_state(std::span<const NodeIndex* const> keys, const NodePath& node) {
    NodeState largest = NodeState::inside_leaf;
    for (const NodeIndex* const key : keys) largest = std::max(largest, key->state(node));
    return largest;
}

std::optional<NodePath> stepped(std::span<const NodeIndex* const> keys, const NodePath& node, NodeStep step) {
    switch (step) {
        case NodeStep::parent:
            return node.level > 0 ? std::optional(parent_of(node)) : std::nullopt;
        case NodeStep::sibling:
            if (node.level == 0 || union_state(keys, node) == NodeState::inside_leaf) return std::nullopt;
            return sibling_of(node);
        case NodeStep::first_child:
        case NodeStep::second_child:
            if (union_state(keys, node) != NodeState::bisected) return std::nullopt;
            return child_of(node, step == NodeStep::first_child ? 0 : 1);
        case NodeStep::across_first:
            return neighbor_across(keys, {node, 0});
        case NodeStep::across_second:
            return neighbor_across(keys, {node, 1});
        case NodeStep::across_third:
            return neighbor_across(keys, {node, 2});
    }
    return std::nullopt;
}

}  // namespace interleaf
