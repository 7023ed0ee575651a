#include "hierarchy/detail/bisection_forest.h"

#include "hierarchy/detail/bisected_nodes.h"

namespace interleaf {

BisectionForest bisection_forest(const Hierarchy& hierarchy) {
    BisectionForest forest;
    forest.bisections.reserve(hierarchy.midpoints.size());
    forest.roots.assign(hierarchy.roots.triangle_count(), no_index);
    forest.at.assign(hierarchy.vertex_count(), {no_index, no_index});
    std::array<Index, max_level> path{};  // the present node and the nodes above it, by level
    for_each_bisected_node(hierarchy, [&](const BisectedNode& node) {
        forest.bisections.push_back({node.midpoint, node.vertices[0]});
        forest.at[node.midpoint][node.is_first_visit ? 0 : 1] = node.place;
        path[node.level] = node.place;
        if (node.level == 0)
            forest.roots[node.root] = node.place;
        else
            forest.bisections[path[node.level - 1]].children[node.child] = node.place;
    });
    return forest;
}

}  // namespace interleaf
