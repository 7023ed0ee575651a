// Steps from node to node of the union of some hierarchies, which need not be made for it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "hierarchy/nodes/node_index.h"
#include "hierarchy/nodes/node_path.h"

namespace interleaf {

enum class NodeStep : std::uint8_t {
    parent,
    sibling,
    first_child,
    second_child,
    across_first,   ///< across the side opposite the first vertex, the refinement edge
    across_second,  ///< across the side opposite the second vertex
    across_third,
};

inline constexpr std::array all_node_steps = {
    NodeStep::parent,       NodeStep::sibling,       NodeStep::first_child, NodeStep::second_child,
    NodeStep::across_first, NodeStep::across_second, NodeStep::across_third};

/// What the union has at \p node.
/// \param keys  at least one, over the same roots
/// \pre  the root of \p node exists
NodeState union_state(std::span<const NodeIndex* const> keys, const NodePath& node);

/// The node of the union that \p step leads to from \p node; none if there is no such node. Across a side lies
/// the smallest node that has the whole of that side: beside a leaf the other leaf.
/// \param keys  as for union_state()
/// \pre  the root of \p node exists
std::optional<NodePath> stepped(std::span<const NodeIndex* const> keys, const NodePath& node, NodeStep step);

}  // namespace interleaf
