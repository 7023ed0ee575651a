// The walk over the preorder that finds the open nodes and makes the connectivity from their decisions. The
// reader and the writer of bisection_decisions.h both use it.
//
// Both sides of an edge share one record of that edge. The record holds the edge's midpoint and halves, if it
// has any. The first visit makes them and the second visit finds them, without search or hashing. During the
// walk the records take 16 bytes per leaf.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "hierarchy/buffer.h"
#include "hierarchy/error.h"
#include "hierarchy/root_complex.h"
#include "hierarchy/triangle.h"
#include "io/hierarchy/bisection_decisions.h"

namespace interleaf::bisection_walk {

/// An edge, shared by both its sides. It has no initial values, so making many edges touches no memory.
struct Edge {
    static constexpr Index open = no_index;       ///< halves: the edge may still get a midpoint
    static constexpr Index whole = no_index - 1;  ///< halves: the edge belongs to a leaf and gets no midpoint

    Index midpoint;
    Index halves;  ///< the first of two consecutive edges; it begins at the first end of the first visit
};

inline constexpr Edge new_edge = {no_index, Edge::open};
inline constexpr MidpointStar no_star = {{no_index, no_index}, {no_index, no_index}};

struct Node {
    Triangle vertices;
    Triangle edges;  ///< each opposite the vertex of the same number
    unsigned level;
};

/// Writes single bits into words, starting with the lowest bit of the first word.
class BitWriter {
  public:
    explicit BitWriter(Buffer<std::uint64_t>& words) : words_(words) {}

    void write(bool bit) {
        word_ |= std::uint64_t{bit} << (count_ % 64);
        if (++count_ % 64 == 0) words_[count_ / 64 - 1] = std::exchange(word_, 0);
    }
    void finish() {
        if (count_ % 64 != 0) words_[count_ / 64] = word_;
    }
    std::size_t count() const { return count_; }

  private:
    Buffer<std::uint64_t>& words_;
    std::uint64_t word_ = 0;
    std::size_t count_ = 0;
};

/// The edge opposite each vertex of each root.
inline std::vector<Triangle> root_edges(const RootComplex& roots, Index& edge_count) {
    const auto neighbors = roots.neighbors();
    std::vector<Triangle> edges(roots.triangle_count());
    edge_count = 0;
    for (Index t = 0; t < edges.size(); ++t)
        for (unsigned side = 0; side < 3; ++side) {
            const Index other = neighbors[t][side];
            if (other > t) {  // or no_index
                edges[t][side] = edge_count++;
                continue;
            }
            const auto back = std::ranges::find(neighbors[other], t) - neighbors[other].begin();
            edges[t][side] = edges[other][static_cast<std::size_t>(back)];
        }
    return edges;
}

/// \p Decisions has two functions. bool peek(position) gives the decision about the node at a position of the
/// preorder, which counts only if the node is open. take(open) follows each peek() and says whether it is.
template <typename Decisions>
class Walk {
  public:
    Walk(const RootComplex& roots, Index midpoint_count, Index vertex_count, Decisions& decisions)
        : roots_(roots), decisions_(decisions), bits_(result_.bits), next_vertex_(roots.vertex_count()) {
        const std::size_t nodes = roots.triangle_count() + 2 * std::size_t{midpoint_count};
        result_.bits.resize((nodes + 63) / 64);
        result_.midpoints.resize(midpoint_count);
        result_.stars.resize(vertex_count);
        result_.levels.resize(vertex_count);
        std::fill_n(result_.stars.begin(), next_vertex_, no_star);
        std::fill_n(result_.levels.begin(), next_vertex_, std::uint8_t{0});

        root_edges_ = root_edges(roots, edge_count_);
        edges_.resize(edge_count_ + 2 * std::size_t{vertex_count - next_vertex_} + midpoint_count);
        std::fill_n(edges_.begin(), edge_count_, new_edge);
    }

    /// \throw InputError unless the decisions give exactly the counted nodes and vertices, at most max_level
    ///                   deep
    Connectivity run() {
        for (Index root = 0; root < root_edges_.size(); ++root)
            walk_root({roots_.triangles()[root], root_edges_[root], 0});
        if (next_midpoint_ != result_.midpoints.size() || next_vertex_ != result_.stars.size())
            throw InputError(fmt::format("{} bisected nodes and {} vertices, expected {} and {}",
                                         next_midpoint_, next_vertex_, result_.midpoints.size(),
                                         result_.stars.size()));
        bits_.finish();
        return std::move(result_);
    }

  private:
    void walk_root(Node node) {
        std::array<Node, max_level + 1> second_children;  // of the nodes above, not visited yet
        std::size_t waiting = 0;
        for (;;) {
            if (is_bisected(node)) {
                bisect_node(node, second_children[waiting++]);
            } else {
                finish_leaf(node);
                if (waiting == 0) return;
                node = second_children[--waiting];
            }
        }
    }

    bool has_midpoint(Index edge) const { return edges_[edge].midpoint != no_index; }

    // The only branch is the caller's, because the kind of a node is hard to predict.
    bool is_bisected(const Node& node) {
        const bool first = has_midpoint(node.edges[0]);
        const bool second = has_midpoint(node.edges[1]);
        const bool third = has_midpoint(node.edges[2]);
        const bool must = first | second | third;
        const bool must_not = edges_[node.edges[0]].halves == Edge::whole;
        if (must & must_not)
            throw InputError(fmt::format("node {}: must be bisected at an edge of a leaf", bits_.count()));
        const bool decision = decisions_.peek(bits_.count());
        decisions_.take(!(must | must_not));
        return must | (decision & !must_not);
    }

    void finish_leaf(const Node& node) {
        bits_.write(false);
        for (const Index edge : node.edges) edges_[edge].halves = Edge::whole;
    }

    /// Replaces \p node by its first child, and sets \p second to its second child.
    void bisect_node(Node& node, Node& second) {
        if (node.level == max_level)
            throw InputError(
                fmt::format("node {}: bisected at level {}, expected leaves at most {} levels deep",
                            bits_.count(), node.level, max_level));
        if (next_midpoint_ == result_.midpoints.size())
            throw InputError(fmt::format("node {}: bisected, but there are only {} midpoints", bits_.count(),
                                         next_midpoint_));
        const auto [near_j, near_k] = split_edge(node);
        bits_.write(true);
        const auto [jk, ki, ij] = node.edges;
        const Index midpoint = edges_[jk].midpoint;
        result_.midpoints[next_midpoint_++] = midpoint;
        const Index inner = edge_count_++;
        edges_[inner] = new_edge;
        // The edges opposite the vertices are ki, il, lk in the child (l, k, i), and ij, jl, li in (l, i, j).
        const auto children = bisect(node.vertices, midpoint);
        second = {children[1], {ij, near_j, inner}, node.level + 1};
        node = {children[0], {ki, inner, near_k}, node.level + 1};
    }

    /// Visits the refinement edge (j, k) of \p node.
    /// \return the halves of the edge at j and at k
    std::pair<Index, Index> split_edge(const Node& node) {
        const auto [i, j, k] = node.vertices;
        Edge& edge = edges_[node.edges[0]];
        if (edge.midpoint != no_index) {
            // The other side ran from k to j.
            result_.stars[edge.midpoint].apexes[1] = i;
            return {edge.halves + 1, edge.halves};
        }
        if (next_vertex_ == result_.stars.size())
            throw InputError(fmt::format("node {}: bisected, but there are only {} vertices", bits_.count(),
                                         next_vertex_));
        result_.stars[next_vertex_] = {{j, k}, {i, no_index}};
        result_.levels[next_vertex_] = static_cast<std::uint8_t>(node.level + 1);
        edge = {next_vertex_++, edge_count_};
        edges_[edge_count_++] = new_edge;
        edges_[edge_count_++] = new_edge;
        return {edge.halves, edge.halves + 1};
    }

    const RootComplex& roots_;
    Decisions& decisions_;
    Connectivity result_;
    BitWriter bits_;
    std::vector<Triangle> root_edges_;
    Buffer<Edge> edges_;
    Index edge_count_ = 0;
    std::size_t next_midpoint_ = 0;
    Index next_vertex_;
};

}  // namespace interleaf::bisection_walk
