// How a red-green key lies over the nodes of a forest that contains the key's own forest. This corresponds to
// level maps for bisection (src/hierarchy/level_map.h), with a case that bisection does not have: a node that
// a green line crosses.
#pragma once

#include <functional>
#include <span>

#include "red_green_key.h"
#include <glm/mat3x3.hpp>

namespace interleaf::bench {

enum class Lie {
    split,   ///< the node is a split node of the key
    leaf,    ///< the node is a leaf of the key, with or without a green line
    whole,   ///< the node lies inside a leaf without a green line
    half,    ///< the node lies inside one of the two green triangles of a leaf
    across,  ///< the node lies inside a leaf whose green line crosses it, along one of the node's medians
};

struct KeyOverNode {
    Lie lie;
    unsigned line;  ///< the median that is a green line of the key, or no_line
    Index leaf;     ///< the leaf of the key that the node is or lies in; the node itself if it is split
    /// Barycentric coordinates of the node's corners in that leaf, one column per corner.
    glm::dmat3 corners;

    /// Whether a line of the key divides the node.
    bool is_cut() const { return line != no_line && (lie == Lie::leaf || lie == Lie::across); }
};

/// The point of \p key at the barycentric coordinates \p b of the node that \p over describes.
/// \pre  the node is not split in the key
glm::dvec3 point_over(const RedGreenKey& key, const KeyOverNode& over, const glm::dvec3& b);

/// Called with a node of the forest and with all keys over it, in their order.
using NodeVisitor = std::function<void(Index node, std::span<const KeyOverNode> keys)>;

/// Visits all nodes of \p forest, each before its children.
/// \pre  \p forest splits every node that a key splits
void visit_nodes(const RedForest& forest, std::span<const RedGreenKey> keys, const NodeVisitor& visit);

}  // namespace interleaf::bench
