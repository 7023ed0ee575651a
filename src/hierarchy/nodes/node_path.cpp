#include "hierarchy/nodes/node_path.h"

#include <span>

namespace interleaf {

namespace {

std::uint64_t bit_of_level(unsigned level) {
    return std::uint64_t{1} << level;
}

/// Which child of its parent the node is.
unsigned last_turn(const NodePath& node) {
    return static_cast<unsigned>(node.path >> (node.level - 1) & 1);
}

std::optional<NodeSide> root_side_across(const RootComplex& roots, Index root, unsigned side) {
    const Index beyond = roots.neighbors()[root][side];
    if (beyond == no_index) return std::nullopt;
    const Triangle& here = roots.triangles()[root];
    const Triangle& there = roots.triangles()[beyond];
    for (unsigned other = 0; other < 3; ++other)
        if (there[(other + 1) % 3] == here[(side + 2) % 3] && there[(other + 2) % 3] == here[(side + 1) % 3])
            return NodeSide{{beyond, 0, 0}, other};
    return std::nullopt;
}

}  // namespace

NodePath child_of(const NodePath& node, unsigned which) {
    return {node.root, node.level + 1, node.path | std::uint64_t{which} << node.level};
}

NodePath parent_of(const NodePath& node) {
    return {node.root, node.level - 1, node.path & ~bit_of_level(node.level - 1)};
}

NodePath sibling_of(const NodePath& node) {
    return {node.root, node.level, node.path ^ bit_of_level(node.level - 1)};
}

NodeSide child_with_side(const NodeSide& side) {
    return {child_of(side.node, side.side - 1), refinement_side};
}

std::optional<NodeSide> side_across(const RootComplex& roots, const NodeSide& side) {
    const NodePath& node = side.node;
    if (node.level == 0) return root_side_across(roots, node.root, side.side);
    const unsigned which = last_turn(node);
    if (side.side == sibling_side[which]) return NodeSide{sibling_of(node), sibling_side[1 - which]};
    // The child inherits its refinement edge whole from the parent's side 1 or 2.
    if (side.side == refinement_side) return side_across(roots, {parent_of(node), 1 + which});
    // A half of the parent's refinement edge. The triangle across that edge is bisected at it, too, with its
    // vertices in the opposite direction. So its other child has this half.
    auto beyond = side_across(roots, {parent_of(node), refinement_side});
    if (beyond && beyond->side != refinement_side && beyond->node.level < max_level)
        beyond = child_with_side(*beyond);
    if (!beyond || beyond->node.level == max_level) return std::nullopt;
    return NodeSide{child_of(beyond->node, 1 - which), half_side[1 - which]};
}

}  // namespace interleaf
