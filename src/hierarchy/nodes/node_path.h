// The nodes of the infinite forest (paper, theorem 1): roots and everything that bisection makes of them. A node
// is named by its root and the path down from it, so its relatives and neighbors follow from the names alone.
#pragma once

#include <cstdint>
#include <optional>

#include "hierarchy/root_complex.h"
#include "hierarchy/triangle.h"

namespace interleaf {

struct NodePath {
    Index root = 0;
    unsigned level = 0;      ///< number of bisections above it, 0 to max_level
    std::uint64_t path = 0;  ///< bit n is the child taken at level n; the bits from \p level on are 0
    bool operator==(const NodePath&) const = default;
};

/// \param which  0 or 1
/// \pre  the node is above max_level
NodePath child_of(const NodePath& node, unsigned which);

/// \pre  the node is no root
NodePath parent_of(const NodePath& node);
NodePath sibling_of(const NodePath& node);

/// A side of a node, numbered as in triangle.h.
struct NodeSide {
    NodePath node;
    unsigned side = 0;  ///< 0 (the refinement edge) to 2
    bool operator==(const NodeSide&) const = default;
};

/// The child that has the whole of a side of its parent as its refinement edge.
/// \pre  the side is no refinement edge, and the node is above max_level
NodeSide child_with_side(const NodeSide& side);

/// The side on the other side of the same edge: the one of the coarsest node there that has the whole edge.
/// None at the boundary, or where that node would be below max_level.
/// \pre  the root exists in \p roots
std::optional<NodeSide> side_across(const RootComplex& roots, const NodeSide& side);

}  // namespace interleaf
