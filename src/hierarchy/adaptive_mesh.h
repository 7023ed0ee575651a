// The adaptive mesh: a conforming triangulation that is refined by Algorithm (A) (paper, section 2, figures 1
// to 3), and coarsened by its inverse.
//
// Only leaves are stored. A leaf knows its vertices, its three neighbours, its level and path, and the leaf
// that follows it in preorder; the forest above the leaves is determined by their levels in that order.
// Bisection keeps the leaf's place for its first child, so root r is where the leaves of root r begin, and
// takes a free place for the second. One bisection costs O(1), and so does its inverse.
//
// refine() bisects a leaf together with its neighbour across the refinement edge, after the neighbour has
// been bisected until they share it; so the mesh conforms after every step. Under a marking of the roots
// where leaves wait for each other in a cycle, the whole cycle is bisected as one step, so refinement ends
// for every marking.
//
// coarsen() removes a midpoint when all leaves around it are marked. The midpoints of a cycle have come as
// one step and go as one.
#pragma once

#include <cassert>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/growing_array.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/root_complex.h"

namespace interleaf {

/// A vertex that bisection has made: \p midpoint, on the edge between the vertices \p a < \p b.
struct NewVertex {
    Index a;
    Index b;
    Index midpoint;
};

/// A rule that puts new vertices somewhere: glm::vec3 rule(Index a, Index b, Index midpoint), the position of
/// the vertex \p midpoint on the edge between \p a and \p b, which have theirs. Asked once for every new
/// vertex, so a caller can keep arrays of its own beside the mesh. The index is the next one, or the last one
/// that coarsening has freed.
template <typename Rule>
concept MidpointRule = std::is_invocable_r_v<glm::vec3, Rule, Index, Index, Index>;

class AdaptiveMesh {
  public:
    AdaptiveMesh(const AdaptiveMesh&) = delete;  // place_vertices_ refers to the mesh
    AdaptiveMesh& operator=(const AdaptiveMesh&) = delete;
    ~AdaptiveMesh() = default;

    /// The roots, unrefined. \p positions holds one position a root vertex. New vertices are put where \p
    /// rule says.
    template <MidpointRule Rule>
    AdaptiveMesh(const RootComplex& roots, std::span<const glm::vec3> positions, Rule rule)
        : AdaptiveMesh(roots, positions,
                       PlaceVertices([this, rule](std::span<const NewVertex> vertices) mutable {
                           for (const auto& [a, b, midpoint] : vertices)
                               positions_[midpoint] = rule(a, b, midpoint);
                       })) {}

    /// The same with new vertices at the mean of the ends of their edge.
    AdaptiveMesh(const RootComplex& roots, std::span<const glm::vec3> positions)
        : AdaptiveMesh(roots, positions,
                       [this](Index a, Index b, Index) { return (positions_[a] + positions_[b]) * 0.5F; }) {}

    Index leaf_count() const { return leaf_bound() - static_cast<Index>(free_leaves_.size()); }
    Index vertex_count() const { return vertex_bound() - static_cast<Index>(free_vertices_.size()); }

    /// Leaves, and vertices, have indices below these. Until the first coarsening every index is taken; it
    /// keeps the indices of what stays, and refinement takes up those it freed.
    Index leaf_bound() const { return static_cast<Index>(leaves_.size()); }
    Index vertex_bound() const { return static_cast<Index>(positions_.size()); }

    /// Whether the index \p leaf, below leaf_bound(), is that of a leaf.
    bool is_leaf(Index leaf) const { return leaves_[leaf].level != no_level; }

    const RootComplex& roots() const { return roots_; }

    /// By vertex, up to vertex_bound(); meaningless at freed indices.
    std::span<const glm::vec3> positions() const { return positions_.span(); }

    const Triangle& vertices(Index leaf) const { return leaves_[leaf].vertices; }

    /// Neighbours of \p leaf across the edges opposite its three vertices; no_index at the boundary.
    const Triangle& neighbours(Index leaf) const { return leaves_[leaf].neighbours; }

    unsigned level(Index leaf) const { return leaves_[leaf].level; }

    /// The way from the root to \p leaf: bit n is set where the bisection of level n went to the second
    /// child.
    std::uint64_t path(Index leaf) const { return leaves_[leaf].path; }

    /// Bisects every leaf in \p marked at least once and closes: the smallest conforming refinement that does
    /// (algorithm (A)). The children of every bisection are appended to \p changed, if given: the first,
    /// in the place of its parent, then the second, bisection after bisection. \throw InputError before a
    /// leaf would pass max_level; the mesh is then conforming, with a part of \p marked refined
    void refine(std::span<const Index> marked, std::vector<Index>* changed = nullptr);

    /// The inverse: removes every midpoint of which all surrounding leaves are in \p marked, so that the
    /// triangles bisected there are leaves again; then the mesh conforms, and the order of \p marked does not
    /// matter. A leaf takes part in at most one removal a call: a midpoint stays while a triangle around it
    /// is bisected. Under a cyclic marking the midpoints that were made in one step are removed in one, when
    /// all leaves around them are marked. \p marked may name a leaf twice; all must be leaves. The triangles
    /// that are leaves again are appended to \p changed, if given, each once.
    void coarsen(std::span<const Index> marked, std::vector<Index>* changed = nullptr);

    /// Number of leaves that refine() of \p leaf alone would add. Changes nothing but scratch memory.
    Index leaves_added_by(Index leaf);

    /// Memory of the mesh and its scratch arrays, in bytes.
    std::size_t byte_count() const;

    /// All leaves, root after root, in the preorder of their trees.
    std::vector<Index> preorder() const;

    /// The frozen hierarchy of the present leaves, with \p fields, which have values up to vertex_bound().
    Hierarchy freeze(std::span<const Field> fields = {}) const;

    /// Every violation of the mesh's own invariants (neighbours mutual and edge-matched, levels, order), one
    /// sentence each; for tests. What makes the frozen hierarchy sound is in checker.h.
    std::vector<std::string> violations() const;

  private:
    /// Gives positions to vertices in their order: one call for many, with the caller's rule inlined in it.
    using PlaceVertices = std::function<void(std::span<const NewVertex>)>;

    AdaptiveMesh(const RootComplex& roots, std::span<const glm::vec3> positions,
                 PlaceVertices place_vertices);

    static constexpr std::uint8_t no_level = 0xff;

    struct LeafRecord {
        Triangle vertices;
        Triangle neighbours;
        Index next;          ///< the next leaf in preorder, no_index after the last
        std::uint8_t level;  ///< no_level where the place is free
        bool is_flagged;  ///< in the chain that is collected, or marked to be coarsened; false between calls
        std::uint64_t path;
    };
    struct Pending {
        Index leaf;
        std::uint8_t level;
    };
    /// Marked leaves that follow each other often have neighbours far apart in memory. What the leaves this
    /// many places later will touch is asked for early, in three steps, so that it arrives together.
    static constexpr std::size_t prefetch_leaf = 32, prefetch_neighbours = 16, prefetch_beyond = 8;
    /// The two children of a triangle, both leaves.
    struct Siblings {
        Index first;
        Index second;
    };
    /// A triangle of a cycle, bisected at its refinement edge and then, on its entry edge, in one child.
    struct CycleMember {
        Index whole;     ///< the child that is a leaf
        bool is_second;  ///< whether that is the second child
        Siblings split;  ///< the children of the other one
    };

    bool is_compatible(Index leaf) const;
    std::size_t collect_chain(Index leaf);
    bool has_levels_left(std::size_t cycle_begin) const;
    bool bisect_with_closure(Index leaf);
    void bisect_pair(Index leaf);
    void bisect_cycle(std::span<const Index> cycle);
    void split(Index leaf, Index second, Index midpoint, std::array<Index, 2> across_halves);
    bool is_second(Index leaf) const;
    bool is_flagged(const Siblings& pair) const;
    std::optional<Siblings> siblings(Index leaf) const;
    bool coarsen_pair(Index leaf);
    std::optional<CycleMember> cycle_member(Index leaf) const;
    Index whole_across(const Siblings& split) const;
    bool collect_cycle(Index leaf);
    bool coarsen_cycle(Index leaf);
    Index merge(const Siblings& pair);
    void prefetch_to_bisect(std::size_t place) const;
    void prefetch_to_merge(std::size_t place) const;
    Index free_place();
    void link(Index a, unsigned side_a, Index b, unsigned side_b);
    void redirect(Index leaf, Index from, Index to);
    Index add_midpoint(Index leaf);
    void place_new_vertices();
    void report_changed(Index leaf) {
        if (changed_ != nullptr) changed_->push_back(leaf);
    }

    RootComplex roots_;
    GrowingArray<LeafRecord> leaves_;
    GrowingArray<glm::vec3> positions_;
    GrowingArray<Index> free_leaves_;
    GrowingArray<Index> free_vertices_;
    PlaceVertices place_vertices_;
    std::vector<NewVertex> new_vertices_;  ///< not placed yet; empty between calls
    std::vector<Index> chain_;
    std::vector<CycleMember> cycle_;
    std::vector<Index>* changed_ = nullptr;  ///< where the present call reports
    GrowingArray<Pending> pending_;
};

// What both refinement and coarsening are made of, here so that it is inlined.

inline bool AdaptiveMesh::is_compatible(Index leaf) const {
    const Index neighbour = leaves_[leaf].neighbours[refinement_side];
    return neighbour == no_index || leaves_[neighbour].neighbours[refinement_side] == leaf;
}

inline bool AdaptiveMesh::is_second(Index leaf) const {
    const LeafRecord& record = leaves_[leaf];
    assert(record.level > 0);
    return (record.path >> (record.level - 1) & 1) != 0;
}

/// Makes \p a and \p b neighbours across these sides of theirs.
inline void AdaptiveMesh::link(Index a, unsigned side_a, Index b, unsigned side_b) {
    leaves_[a].neighbours[side_a] = b;
    leaves_[b].neighbours[side_b] = a;
}

/// The neighbour \p from of \p leaf has become \p to. Computed, not branched to: the side cannot be
/// predicted.
inline void AdaptiveMesh::redirect(Index leaf, Index from, Index to) {
    Triangle& sides = leaves_[leaf].neighbours;
    const unsigned not_0 = sides[0] != from;
    const unsigned side = not_0 + (not_0 & static_cast<unsigned>(sides[1] != from));
    assert(sides[side] == from);
    sides[side] = to;
}

/// A place for a leaf: the one that was freed last, or a new one at the end.
inline Index AdaptiveMesh::free_place() {
    if (free_leaves_.empty()) return static_cast<Index>(leaves_.append());
    const Index place = free_leaves_.back();
    free_leaves_.pop_back();
    return place;
}

}  // namespace interleaf
