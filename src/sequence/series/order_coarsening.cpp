#include "sequence/series/order_coarsening.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <glm/geometric.hpp>

namespace interleaf {

namespace {

/// The triangles of a step while they are replaced by their parents. A parent takes the place of its child with
/// the lower number.
class OrderCoarsening {
  public:
    OrderCoarsening(const StepMesh& step, const OrderRule& rule) : step_(step), rule_(rule) {
        const std::size_t count = step.triangles.size();
        triangles_.reserve(count);
        neighbors_.reserve(count);
        for (Index t = 0; t < count; ++t) {
            triangles_.push_back(step.oriented(t, rule.newest));
            neighbors_.push_back(step.oriented_neighbors(t, rule.newest));
            nodes_.push_back(t);
        }
        corner_counts_.assign(step.points.size(), 0);
        newest_counts_.assign(step.points.size(), 0);
        triangle_at_.assign(step.points.size(), no_index);
        for (Index t = 0; t < count; ++t) {
            for (const Index vertex : triangles_[t]) {
                ++corner_counts_[vertex];
                triangle_at_[vertex] = t;
            }
            ++newest_counts_[triangles_[t][0]];
        }
    }

    void coarsen() {
        const auto vertex_count = static_cast<Index>(corner_counts_.size());
        is_waiting_.assign(vertex_count, true);
        for (Index vertex = 0; vertex < vertex_count; ++vertex) waiting_.push_back(vertex);
        for (std::size_t next = 0; next < waiting_.size(); ++next) {
            const Index vertex = waiting_[next];
            is_waiting_[vertex] = false;
            if (corner_counts_[vertex] == newest_counts_[vertex]) remove(vertex);
        }
    }

    std::size_t root_count() const { return triangles_.size() - merges_.size(); }

    OrderedForest forest() const {
        OrderedForest forest;
        forest.deviation = merges_.empty() ? 0 : deviation_ / static_cast<double>(merges_.size());
        forest.leaves.reserve(triangles_.size());
        for (Index place = 0; place < triangles_.size(); ++place)
            if (nodes_[place] != no_index) {
                forest.roots.push_back(triangles_[place]);
                append_leaves(nodes_[place], forest.leaves);
            }
        return forest;
    }

  private:
    /// A parent: its children as nodes. Nodes are the triangles of the step, then the merges.
    struct Merge {
        Index first;
        Index second;
    };

    Index next_around(Index triangle) const { return neighbors_[triangle][1]; }
    Index previous_around(Index triangle) const { return neighbors_[triangle][2]; }

    /// Removes \p vertex if it is good. It is the newest vertex of all its triangles.
    void remove(Index vertex) {
        const std::uint32_t count = corner_counts_[vertex];
        Index start = triangle_at_[vertex];
        if (count == 2) {
            if (previous_around(start) != no_index) start = previous_around(start);
            const Index second = next_around(start);
            if (second == no_index || previous_around(start) != no_index || next_around(second) != no_index)
                return;
            if (triangles_[start][1] == triangles_[second][2]) return;
            merge_pair(start, second);
        } else if (count == 4) {
            std::array<Index, 4> ring = {start, no_index, no_index, no_index};
            for (std::size_t i = 1; i < 4; ++i) {
                ring[i] = next_around(ring[i - 1]);
                if (ring[i] == no_index) return;
            }
            if (next_around(ring[3]) != ring[0]) return;
            turn_to_first_child(ring);
            if (triangles_[ring[0]][1] == triangles_[ring[2]][1] ||
                triangles_[ring[1]][1] == triangles_[ring[3]][1])
                return;
            const Index parent = merge_pair(ring[0], ring[1]);
            const Index other = merge_pair(ring[2], ring[3]);
            neighbors_[parent][refinement_side] = other;
            neighbors_[other][refinement_side] = parent;
        }
    }

    void turn_to_first_child(std::array<Index, 4>& ring) const {
        std::rotate(ring.begin(), std::ranges::min_element(ring), ring.end());
        if (rule_.lowest_is_second) std::rotate(ring.begin(), ring.end() - 1, ring.end());
    }

    /// Replaces two siblings by their parent, whose neighbor across the refinement edge stays unset.
    Index merge_pair(Index first, Index second) {
        const Index vertex = triangles_[first][0];
        const Triangle parent = merge(triangles_[first], triangles_[second]);
        deviation_ += deviation(vertex, parent[1], parent[2]);
        const Index place = std::min(first, second);
        const Index freed = std::max(first, second);
        const Triangle around = {no_index, neighbors_[first][0], neighbors_[second][0]};
        redirect(around[1], first, place);
        redirect(around[2], second, place);
        merges_.push_back({nodes_[first], nodes_[second]});
        nodes_[place] = static_cast<Index>(triangles_.size() + merges_.size() - 1);
        nodes_[freed] = no_index;
        triangles_[place] = parent;
        neighbors_[place] = around;

        corner_counts_[vertex] -= 2;
        newest_counts_[vertex] -= 2;
        --corner_counts_[parent[0]];
        ++newest_counts_[parent[0]];
        for (const Index corner : parent) {
            triangle_at_[corner] = place;
            if (is_waiting_[corner]) continue;
            is_waiting_[corner] = true;
            waiting_.push_back(corner);
        }
        return place;
    }

    void redirect(Index triangle, Index from, Index to) {
        if (triangle != no_index) std::ranges::replace(neighbors_[triangle], from, to);
    }

    double deviation(Index vertex, Index a, Index b) const {
        const glm::dvec3 p = step_.points[a];
        const glm::dvec3 q = step_.points[b];
        const double length = glm::distance(p, q);
        return length > 0 ? glm::distance(step_.points[vertex], (p + q) / 2.0) / length : 0;
    }

    /// Appends the leaves below the node \p root in preorder.
    void append_leaves(Index root, std::vector<Leaf>& leaves) const {
        struct Open {
            Index node;
            unsigned level;
        };
        std::vector<Open> open = {{root, 0}};
        while (!open.empty()) {
            const auto [node, level] = open.back();
            open.pop_back();
            if (node < triangles_.size()) {
                leaves.push_back({step_.oriented(node, rule_.newest),
                                  static_cast<std::uint8_t>(std::min(level, max_level + 1))});
                continue;
            }
            const Merge& children = merges_[node - triangles_.size()];
            open.push_back({children.second, level + 1});
            open.push_back({children.first, level + 1});
        }
    }

    const StepMesh& step_;
    OrderRule rule_;
    std::vector<Triangle> triangles_;  ///< by place
    std::vector<Triangle> neighbors_;  ///< by place, across the sides
    std::vector<Index> nodes_;         ///< by place; no_index at freed places
    std::vector<Merge> merges_;
    std::vector<std::uint32_t> corner_counts_;  ///< per vertex: its triangles
    std::vector<std::uint32_t>
        newest_counts_;               ///< per vertex: the triangles of which it is the newest vertex
    std::vector<Index> triangle_at_;  ///< per vertex: one of its triangles
    std::vector<Index> waiting_;      ///< vertices to look at, in order
    std::vector<bool> is_waiting_;    ///< per vertex
    double deviation_ = 0;
};

/// Whether no leaf is deeper than a hierarchy allows.
bool has_few_levels(const OrderedForest& forest) {
    return std::ranges::all_of(forest.leaves, [](const Leaf& leaf) { return leaf.level <= max_level; });
}

}  // namespace

std::optional<OrderedForest> coarsen_by_order(const StepMesh& step, const OrderRule& rule,
                                              std::size_t max_roots) {
    OrderCoarsening coarsening(step, rule);
    coarsening.coarsen();
    if (coarsening.root_count() > max_roots) return std::nullopt;
    OrderedForest forest = coarsening.forest();
    if (!has_few_levels(forest)) return std::nullopt;
    return forest;
}

}  // namespace interleaf
