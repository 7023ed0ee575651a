// How a red-green key lies over the nodes of a forest that contains its own: what level maps are for
// bisection (src/hierarchy/level_map.h), with the case that bisection does not have, a node that a green line
// crosses.
#pragma once

#include <functional>
#include <span>

#include "red_green_key.h"
#include <glm/mat3x3.hpp>

namespace interleaf::bench {

enum class Lie {
    split,   ///< the node is one of the key's, and split
    leaf,    ///< the node is a leaf of the key, with or without a green line
    whole,   ///< it lies inside a leaf that has no green line
    half,    ///< it lies inside one of the two green triangles of a leaf
    across,  ///< it lies inside a leaf whose green line crosses it, along one of its medians
};

struct KeyOverNode {
    Lie lie;
    unsigned line;  ///< the median that is a green line of the key, or no_line
    Index leaf;     ///< the leaf of the key that the node is or lies in; the node itself where it is split
    glm::dmat3 corners;  ///< barycentric coordinates of the node's corners there, a column each

    /// Whether a line of the key divides the node.
    bool is_cut() const { return line != no_line && (lie == Lie::leaf || lie == Lie::across); }
};

/// The point of \p key at the barycentric coordinates \p b of the node that \p over is about.
/// \pre the node is not split in the key
glm::dvec3 point_over(const RedGreenKey& key, const KeyOverNode& over, const glm::dvec3& b);

/// Told of a node of the forest and of all keys over it, in their order.
using NodeVisitor = std::function<void(Index node, std::span<const KeyOverNode> keys)>;

/// Visits all nodes of \p forest, each before its children. \pre \p forest splits whatever a key splits
void visit_nodes(const RedForest& forest, std::span<const RedGreenKey> keys, const NodeVisitor& visit);

}  // namespace interleaf::bench
