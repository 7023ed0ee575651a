// The bisected nodes of a hierarchy, in preorder.
#pragma once

#include <array>
#include <cstddef>

#include "hierarchy/hierarchy.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// A bisected node, as the preorder yields it.
struct BisectedNode {
    Triangle vertices;
    Index midpoint;       ///< the vertex at the middle of its refinement edge
    Index place;          ///< in Hierarchy::midpoints
    unsigned level;       ///< number of bisections above it, below max_level
    unsigned child;       ///< which child of its parent it is, 0 or 1; 0 for a root
    Index root;           ///< the root triangle above it, or itself
    bool is_first_visit;  ///< whether the preorder visits the midpoint for the first time
};

/// Calls \p visit(const BisectedNode&) for every bisected node of \p hierarchy, parents before their children.
/// \pre  the hierarchy passes check()
template <typename Visit>
void for_each_bisected_node(const Hierarchy& hierarchy, Visit visit) {
    struct Node {
        Triangle vertices;
        unsigned level;
        unsigned child;
    };
    std::array<Node, max_level + 2> pending;
    std::size_t position = 0;
    Index place = 0;
    Index next_vertex = hierarchy.roots.vertex_count();
    Index root_number = 0;
    for (const Triangle& root : hierarchy.roots.triangles()) {
        std::size_t pending_count = 0;
        pending[pending_count++] = {root, 0, 0};
        while (pending_count > 0) {
            const Node node = pending[--pending_count];
            if (!hierarchy.is_bisected(position++)) continue;
            const Index midpoint = hierarchy.midpoints[place];
            const bool is_new = midpoint == next_vertex;
            if (is_new) ++next_vertex;
            visit(BisectedNode{node.vertices, midpoint, place, node.level, node.child, root_number, is_new});
            ++place;
            const auto [first, second] = bisect(node.vertices, midpoint);
            pending[pending_count++] = {second, node.level + 1, 1};
            pending[pending_count++] = {first, node.level + 1, 0};
        }
        ++root_number;
    }
}

}  // namespace interleaf
