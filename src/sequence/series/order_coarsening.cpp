#include "sequence/series/order_coarsening.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <glm/geometric.hpp>

#include "hierarchy/buffer.h"

namespace interleaf {

namespace {

/// The triangles of a step while they are replaced by their parents. A parent takes the place of its child with
/// the lower number.
class OrderCoarsening {
  public:
    OrderCoarsening(const StepMesh& step, const OrderRule& rule) : step_(step), rule_(rule) {
        const auto count = static_cast<Index>(step.triangles.size());
        vertices_.assign(step.points.size(), {});
        places_.resize(count);
        nodes_.resize(count);
        for (Index t = 0; t < count; ++t) {
            places_[t] = {step.oriented(t, rule.newest), step.oriented_neighbors(t, rule.newest)};
            nodes_[t] = t;
            for (const Index corner : places_[t].corners) ++vertices_[corner].triangle_count;
            ++vertices_[places_[t].corners[0]].newest_count;
        }
    }

    /// Removes vertices until none is good. The forest does not depend on the order of removal. Programs write
    /// triangles that are near each other one after the other, so to go on at the new parent keeps to the cache.
    void coarsen() {
        for (Index place = 0; place < places_.size(); ++place) {
            waiting_.push_back(place);
            while (!waiting_.empty()) {
                const Index start = waiting_.back();
                waiting_.pop_back();
                if (may_be_good(places_[start].corners[0])) remove_if_good(start);
            }
        }
    }

    std::size_t root_count() const { return places_.size() - merges_.size(); }

    OrderedForest forest() const {
        OrderedForest forest;
        forest.deviation = merges_.empty() ? 0 : deviation_ / static_cast<double>(merges_.size());
        forest.leaves.reserve(places_.size());
        for (Index place = 0; place < places_.size(); ++place)
            if (nodes_[place] != no_index) {
                forest.roots.push_back(places_[place].corners);
                append_leaves(nodes_[place], forest.leaves);
            }
        return forest;
    }

  private:
    /// A triangle, the newest vertex first, and its neighbors across the sides opposite its corners.
    struct Place {
        Triangle corners;
        Triangle neighbors;
    };
    /// The triangles of a vertex: how many there are, and of how many it is the newest vertex.
    struct Vertex {
        std::uint32_t triangle_count = 0;
        std::uint32_t newest_count = 0;
    };
    /// A parent: its children as nodes. Nodes are the triangles of the step, then the merges.
    struct Merge {
        Index first;
        Index second;
    };

    bool may_be_good(Index vertex) const {
        const auto [count, newest_count] = vertices_[vertex];
        return count == newest_count && (count == 2 || count == 4);
    }

    Index next_around(Index triangle) const { return places_[triangle].neighbors[1]; }
    Index previous_around(Index triangle) const { return places_[triangle].neighbors[2]; }

    /// Replaces the two or four triangles around the newest vertex of \p start by their parents, unless they are
    /// open where they should be closed. It is the newest vertex of all of them.
    void remove_if_good(Index start) {
        if (vertices_[places_[start].corners[0]].triangle_count == 2)
            remove_at_boundary(start);
        else
            remove_inside(start);
    }

    void remove_at_boundary(Index start) {
        const Index first = previous_around(start) == no_index ? start : previous_around(start);
        const Index second = next_around(first);
        if (second == no_index || previous_around(first) != no_index || next_around(second) != no_index)
            return;
        if (places_[first].corners[1] != places_[second].corners[2]) merge_pair(first, second);
    }

    void remove_inside(Index start) {
        std::array<Index, 4> ring = {start, no_index, no_index, no_index};
        for (std::size_t i = 1; i < 4; ++i) {
            ring[i] = next_around(ring[i - 1]);
            if (ring[i] == no_index) return;
        }
        if (next_around(ring[3]) != ring[0]) return;
        const auto around = [&](std::size_t i) { return places_[ring[i]].corners[1]; };
        if (around(0) == around(2) || around(1) == around(3)) return;

        std::rotate(ring.begin(), std::ranges::min_element(ring), ring.end());
        if (rule_.lowest_is_second) std::rotate(ring.begin(), ring.end() - 1, ring.end());
        const Index parent = merge_pair(ring[0], ring[1]);
        const Index other = merge_pair(ring[2], ring[3]);
        places_[parent].neighbors[refinement_side] = other;
        places_[other].neighbors[refinement_side] = parent;
    }

    /// Replaces two siblings by their parent, whose neighbor across the refinement edge stays unset.
    Index merge_pair(Index first, Index second) {
        const Index vertex = places_[first].corners[0];
        const Triangle parent = merge(places_[first].corners, places_[second].corners);
        deviation_ += deviation(vertex, parent[1], parent[2]);
        const Index place = std::min(first, second);
        const Triangle around = {no_index, places_[first].neighbors[0], places_[second].neighbors[0]};
        redirect(around[1], first, place);
        redirect(around[2], second, place);
        places_[place] = {parent, around};

        merges_.push_back({nodes_[first], nodes_[second]});
        nodes_[std::max(first, second)] = no_index;
        nodes_[place] = static_cast<Index>(places_.size() + merges_.size() - 1);

        vertices_[vertex].triangle_count -= 2;
        vertices_[vertex].newest_count -= 2;
        --vertices_[parent[0]].triangle_count;
        ++vertices_[parent[0]].newest_count;
        waiting_.push_back(place);  // no other vertex has become good
        return place;
    }

    void redirect(Index triangle, Index from, Index to) {
        if (triangle != no_index) std::ranges::replace(places_[triangle].neighbors, from, to);
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
            if (node < places_.size()) {
                leaves.push_back({step_.oriented(node, rule_.newest),
                                  static_cast<std::uint8_t>(std::min(level, max_level + 1))});
                continue;
            }
            const Merge& children = merges_[node - places_.size()];
            open.push_back({children.second, level + 1});
            open.push_back({children.first, level + 1});
        }
    }

    const StepMesh& step_;
    OrderRule rule_;
    Buffer<Place> places_;     ///< a freed place keeps its corners, the first of which is removed
    Buffer<Vertex> vertices_;  ///< without triangles where removed
    Buffer<Index> nodes_;      ///< by place; no_index at freed places
    Buffer<Merge> merges_;
    std::vector<Index> waiting_;  ///< places whose newest vertex may be good
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
