#include "hierarchy/detail/level_cut.h"

#include <array>
#include <cstdint>
#include <vector>

#include "hierarchy/triangle.h"

namespace interleaf {

namespace {

/// Calls \p bisected(root, level) for every bisected node and \p leaf(root, level) for every leaf, in preorder.
template <typename Bisected, typename IsLeaf>
void walk_levels(const Hierarchy& key, Bisected bisected, IsLeaf leaf) {
    std::vector<std::uint8_t> pending;
    std::size_t position = 0;
    for (Index root = 0; root < key.roots.triangle_count(); ++root) {
        pending.push_back(0);
        while (!pending.empty()) {
            const std::uint8_t level = pending.back();
            pending.pop_back();
            if (!key.is_bisected(position++)) {
                leaf(root, level);
                continue;
            }
            bisected(root, level);
            pending.insert(pending.end(), 2, static_cast<std::uint8_t>(level + 1));
        }
    }
}

}  // namespace

Hierarchy cut_at_level(const Hierarchy& key, unsigned level) {
    std::vector<Leaf> leaves;
    std::vector<Triangle>
        pending;  // the nodes down to the level that the walk has not reached yet, the next one last
    std::size_t next_midpoint = 0;
    const auto next_node = [&](Index root, std::uint8_t at) {
        if (at == 0) pending.push_back(key.roots.triangles()[root]);
        const Triangle node = pending.back();
        pending.pop_back();
        return node;
    };
    walk_levels(
        key,
        [&](Index root, std::uint8_t at) {
            const Index midpoint = key.midpoints[next_midpoint++];
            if (at > level) return;
            const Triangle node = next_node(root, at);
            if (at == level) {
                leaves.push_back({node, at});
                return;
            }
            const auto [first, second] = bisect(node, midpoint);
            pending.push_back(second);
            pending.push_back(first);
        },
        [&](Index root, std::uint8_t at) {
            if (at <= level) leaves.push_back({next_node(root, at), at});
        });
    return hierarchy_from_leaves(key.roots, leaves, key.positions);
}

unsigned level_with_at_most(const Hierarchy& key, std::size_t max_leaves) {
    std::array<std::size_t, max_level + 1> bisected{};  // by level
    walk_levels(
        key, [&](Index, std::uint8_t at) { ++bisected[at]; }, [](Index, std::uint8_t) {});
    std::size_t leaves = key.roots.triangle_count();
    unsigned level = 0;
    while (level < max_level && leaves + bisected[level] <= max_leaves) leaves += bisected[level++];
    return level;
}

}  // namespace interleaf
