// The adaptive mesh of a frozen key: the inverse of freeze(). One walk in preorder gives the leaves; the two
// leaves at an edge find each other through the ends of the edge.
#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include "hierarchy/adaptive_mesh.h"

namespace interleaf {

namespace {

/// A side of a leaf.
struct LeafSide {
    Index end;  ///< the end of the edge with the higher number
    Index leaf;
    unsigned side;
};

/// The ends of the edge opposite the vertex \p side, the lower number first.
std::pair<Index, Index> ends_of_side(const Triangle& vertices, unsigned side) {
    return std::minmax(Index{vertices[(side + 1) % 3]}, Index{vertices[(side + 2) % 3]});
}

}  // namespace

AdaptiveMesh::AdaptiveMesh(const Hierarchy& key, PlaceVertices place_vertices)
    : roots_(key.roots), positions_(key.positions), place_vertices_(std::move(place_vertices)) {
    take_leaves(key);
    link_leaves();
}

/// Puts the first leaf of root r in the place r, and all others behind.
void AdaptiveMesh::take_leaves(const Hierarchy& key) {
    struct Node {
        Triangle vertices;
        std::uint8_t level;
        std::uint64_t path;
    };
    for (std::size_t leaf = 0; leaf < key.leaf_count(); ++leaf) leaves_.append();
    std::vector<Node> pending;
    std::size_t position = 0;
    auto midpoint = key.midpoints.begin();
    Index behind = roots_.triangle_count();
    Index last = no_index;
    for (Index root = 0; root < roots_.triangle_count(); ++root) {
        pending.push_back({roots_.triangles()[root], 0, 0});
        bool is_first = true;
        while (!pending.empty()) {
            const Node node = pending.back();
            pending.pop_back();
            if (key.is_bisected(position++)) {
                const auto [first, second] = bisect(node.vertices, *midpoint++);
                const auto level = static_cast<std::uint8_t>(node.level + 1);
                pending.push_back({second, level, node.path | std::uint64_t{1} << node.level});
                pending.push_back({first, level, node.path});
                continue;
            }
            const Index place = is_first ? root : behind++;
            is_first = false;
            leaves_[place] = {node.vertices, {no_index, no_index, no_index}, no_index, node.level, false,
                              node.path};
            if (last != no_index) leaves_[last].next = place;
            last = place;
        }
    }
    assert(behind == leaves_.size());
}

/// Makes leaves neighbors that share an edge. The sides are sorted by the lower end of their edge, then by the
/// other end.
void AdaptiveMesh::link_leaves() {
    std::vector<Index> begins(positions_.size() + 1, 0);
    const auto for_all_sides = [&](auto what) {
        for (Index leaf = 0; leaf < leaves_.size(); ++leaf)
            for (unsigned side = 0; side < 3; ++side) what(leaf, side);
    };
    for_all_sides(
        [&](Index leaf, unsigned side) { ++begins[ends_of_side(leaves_[leaf].vertices, side).first + 1]; });
    for (std::size_t vertex = 1; vertex < begins.size(); ++vertex) begins[vertex] += begins[vertex - 1];
    std::vector<LeafSide> sides(3 * leaves_.size());
    std::vector<Index> next(begins.begin(), begins.end() - 1);
    for_all_sides([&](Index leaf, unsigned side) {
        const auto [low, high] = ends_of_side(leaves_[leaf].vertices, side);
        sides[next[low]++] = {high, leaf, side};
    });
    for (std::size_t vertex = 0; vertex + 1 < begins.size(); ++vertex) {
        const std::span<LeafSide> here(&sides[0] + begins[vertex], &sides[0] + begins[vertex + 1]);
        std::ranges::sort(here, {}, &LeafSide::end);
        for (std::size_t n = 0; n + 1 < here.size(); ++n)
            if (here[n].end == here[n + 1].end)
                link(here[n].leaf, here[n].side, here[n + 1].leaf, here[n + 1].side);
    }
}

}  // namespace interleaf
