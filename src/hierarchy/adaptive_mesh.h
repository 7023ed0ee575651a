// The adaptive mesh: a conforming triangulation that Algorithm (A) refines (paper, section 2, figures 1 to
// 3), and that the inverse of Algorithm (A) coarsens.
//
// The mesh stores leaves only. A leaf knows its vertices, its three neighbors, its level and path, and the
// next leaf in preorder. The levels in that order determine the forest above the leaves. Bisection reuses the
// leaf's place for its first child and takes a free place for the second, so the leaves of root r begin at
// place r. One bisection costs O(1), and so does its inverse.
//
// refine() bisects a leaf together with its neighbor across the refinement edge. Before that, it bisects the
// neighbor until the two share that edge, so the mesh conforms after every step. Under a marking of the
// roots where leaves wait for each other in a cycle, refine() bisects the whole cycle as one step, so it ends
// for every marking.
//
// coarsen() removes a midpoint when all leaves around it are marked. The midpoints of a cycle were made as
// one step and are removed as one step.
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

/// A vertex made by bisection: \p midpoint, on the edge between the vertices \p a < \p b.
struct NewVertex {
    Index a;
    Index b;
    Index midpoint;
};

/// A rule that places new vertices: glm::vec3 rule(Index a, Index b, Index midpoint) returns the position of
/// the vertex \p midpoint on the edge between \p a and \p b, whose positions are known.
///
/// The mesh calls the rule once for every new vertex, so a caller can keep its own arrays beside the mesh.
/// The index of the vertex is the next unused one, or the last one that coarsening has freed.
template <typename Rule>
concept MidpointRule = std::is_invocable_r_v<glm::vec3, Rule, Index, Index, Index>;

class AdaptiveMesh {
  public:
    AdaptiveMesh(const AdaptiveMesh&) = delete;  // place_vertices_ refers to the mesh
    AdaptiveMesh& operator=(const AdaptiveMesh&) = delete;
    ~AdaptiveMesh() = default;

    /// The unrefined roots.
    /// \param positions  one per root vertex
    /// \param rule       places new vertices
    template <MidpointRule Rule>
    AdaptiveMesh(const RootComplex& roots, std::span<const glm::vec3> positions, Rule rule)
        : AdaptiveMesh(roots, positions, placing(*this, rule)) {}

    /// As above, with new vertices at the mean of the ends of their edge.
    AdaptiveMesh(const RootComplex& roots, std::span<const glm::vec3> positions)
        : AdaptiveMesh(roots, positions,
                       [this](Index a, Index b, Index) { return (positions_[a] + positions_[b]) * 0.5F; }) {}

    /// The leaves of \p key. The vertices keep their numbers, so fields of \p key can be kept beside the mesh.
    /// \param rule  places new vertices
    /// \pre \p key passes check()
    template <MidpointRule Rule>
    AdaptiveMesh(const Hierarchy& key, Rule rule) : AdaptiveMesh(key, placing(*this, rule)) {}

    Index leaf_count() const { return leaf_bound() - static_cast<Index>(free_leaves_.size()); }
    Index vertex_count() const { return vertex_bound() - static_cast<Index>(free_vertices_.size()); }

    /// The indices of leaves, and of vertices, are below these bounds. Until the first coarsening every index
    /// is in use. Coarsening keeps the indices of the leaves and vertices that stay, and refinement reuses
    /// the freed ones.
    Index leaf_bound() const { return static_cast<Index>(leaves_.size()); }
    Index vertex_bound() const { return static_cast<Index>(positions_.size()); }

    /// Whether \p leaf, an index below leaf_bound(), is the index of a leaf.
    bool is_leaf(Index leaf) const { return leaves_[leaf].level != no_level; }

    const RootComplex& roots() const { return roots_; }

    /// By vertex, up to vertex_bound(); meaningless at freed indices.
    std::span<const glm::vec3> positions() const { return positions_.span(); }

    const Triangle& vertices(Index leaf) const { return leaves_[leaf].vertices; }

    /// Neighbors of \p leaf across the edges opposite its three vertices; no_index at the boundary.
    const Triangle& neighbors(Index leaf) const { return leaves_[leaf].neighbors; }

    unsigned level(Index leaf) const { return leaves_[leaf].level; }

    /// The path from the root to \p leaf: bit n is set if the path takes the second child at level n.
    std::uint64_t path(Index leaf) const { return leaves_[leaf].path; }

    /// Bisects every leaf in \p marked at least once, and closes: the result is the smallest conforming
    /// refinement with that property (Algorithm (A)).
    /// \param changed  if given, receives the children of every bisection, bisection after bisection: first
    ///     the first child, in the place of its parent, then the second
    /// \throw InputError before a leaf would exceed max_level; the mesh is then conforming, and a part of
    ///     \p marked is refined
    void refine(std::span<const Index> marked, std::vector<Index>* changed = nullptr);

    /// The inverse of refine(): removes every midpoint whose surrounding leaves are all in \p marked. The
    /// triangles that were bisected there become leaves again, and the mesh conforms.
    ///
    /// The order of \p marked does not matter. A leaf takes part in at most one removal per call: a midpoint
    /// stays while a triangle around it is bisected. Under a cyclic marking, the midpoints that were made in
    /// one step are removed in one step, when all leaves around them are marked.
    /// \param marked   leaves; may name a leaf twice
    /// \param changed  if given, receives the triangles that are leaves again, each once
    void coarsen(std::span<const Index> marked, std::vector<Index>* changed = nullptr);

    /// Number of leaves that refine() of \p leaf alone would add. Changes nothing but scratch memory.
    Index leaves_added_by(Index leaf);

    /// Memory of the mesh and its scratch arrays, in bytes.
    std::size_t byte_count() const;

    /// All leaves, root after root, in the preorder of their trees.
    std::vector<Index> preorder() const;

    /// The frozen hierarchy of the present leaves.
    /// \param fields  the fields of the hierarchy, with values up to vertex_bound()
    Hierarchy freeze(std::span<const Field> fields = {}) const;

    /// Every violation of the mesh's own invariants (mutual and edge-matched neighbors, levels, order), one
    /// sentence per violation; for tests. checker.h states when the frozen hierarchy is sound.
    std::vector<std::string> violations() const;

  private:
    /// Places vertices in their order. One call places many vertices, with the caller's rule inlined.
    using PlaceVertices = std::function<void(std::span<const NewVertex>)>;

    template <MidpointRule Rule>
    static PlaceVertices placing(AdaptiveMesh& mesh, Rule rule) {
        return [&mesh, rule](std::span<const NewVertex> vertices) mutable {
            for (const auto& [a, b, midpoint] : vertices) mesh.positions_[midpoint] = rule(a, b, midpoint);
        };
    }

    AdaptiveMesh(const RootComplex& roots, std::span<const glm::vec3> positions,
                 PlaceVertices place_vertices);
    AdaptiveMesh(const Hierarchy& key, PlaceVertices place_vertices);

    static constexpr std::uint8_t no_level = 0xff;

    struct LeafRecord {
        Triangle vertices;
        Triangle neighbors;
        Index next;          ///< the next leaf in preorder, no_index after the last
        std::uint8_t level;  ///< no_level if the place is free
        bool is_flagged;     ///< in the current chain, or marked for coarsening; false between calls
        std::uint64_t path;
    };
    struct Pending {
        Index leaf;
        std::uint8_t level;
    };
    /// Consecutive marked leaves often have neighbors that are far apart in memory. The mesh prefetches what
    /// the leaves these many places ahead will touch, in three steps, so that the data arrive together.
    static constexpr std::size_t prefetch_leaf = 32, prefetch_neighbors = 16, prefetch_beyond = 8;
    /// The two children of a triangle, both leaves.
    struct Siblings {
        Index first;
        Index second;
    };
    /// A triangle of a cycle: it is bisected at its refinement edge, and then one child is bisected at the
    /// entry edge.
    struct CycleMember {
        Index whole;     ///< the child that is a leaf
        bool is_second;  ///< whether `whole` is the second child
        Siblings split;  ///< the children of the other child
    };

    void take_leaves(const Hierarchy& key);
    void link_leaves();
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

// Steps that refinement and coarsening share. They are defined here so that they are inlined.

inline bool AdaptiveMesh::is_compatible(Index leaf) const {
    const Index neighbor = leaves_[leaf].neighbors[refinement_side];
    return neighbor == no_index || leaves_[neighbor].neighbors[refinement_side] == leaf;
}

inline bool AdaptiveMesh::is_second(Index leaf) const {
    const LeafRecord& record = leaves_[leaf];
    assert(record.level > 0);
    return (record.path >> (record.level - 1) & 1) != 0;
}

/// Makes \p a and \p b neighbors: \p b across side \p side_a of \p a, and \p a across side \p side_b of
/// \p b.
inline void AdaptiveMesh::link(Index a, unsigned side_a, Index b, unsigned side_b) {
    leaves_[a].neighbors[side_a] = b;
    leaves_[b].neighbors[side_b] = a;
}

/// Replaces the neighbor \p from of \p leaf by \p to. The side is computed without a branch, because it is
/// unpredictable.
inline void AdaptiveMesh::redirect(Index leaf, Index from, Index to) {
    Triangle& sides = leaves_[leaf].neighbors;
    const unsigned not_0 = sides[0] != from;
    const unsigned side = not_0 + (not_0 & static_cast<unsigned>(sides[1] != from));
    assert(sides[side] == from);
    sides[side] = to;
}

/// A place for a leaf: the place freed last, or a new one at the end.
inline Index AdaptiveMesh::free_place() {
    if (free_leaves_.empty()) return static_cast<Index>(leaves_.append());
    const Index place = free_leaves_.back();
    free_leaves_.pop_back();
    return place;
}

}  // namespace interleaf
