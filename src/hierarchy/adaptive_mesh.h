// The adaptive mesh: a conforming triangulation that is refined by Algorithm (A) (paper, section 2, figures 1
// to 3).
//
// Only leaves are stored. A leaf knows its vertices, its three neighbours, its level and path, and the leaf
// that follows it in preorder; the forest above the leaves is determined by their levels in that order.
// Bisection keeps the leaf's place for its first child and appends the second, so root r is where the leaves
// of root r begin. One bisection costs O(1).
//
// refine() bisects a leaf together with its neighbour across the refinement edge, after the neighbour has
// been bisected until they share it; so the mesh conforms after every step. Under a marking of the roots
// where leaves wait for each other in a cycle, the whole cycle is bisected as one step, so refinement ends
// for every marking.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
#include "hierarchy/root_complex.h"

namespace interleaf {

/// Position of the new vertex on the edge between vertices \p a and \p b. Called once for every new vertex,
/// in the order of their indices, so a caller can keep arrays of its own beside the mesh.
using MidpointRule = std::function<glm::vec3(Index a, Index b)>;

class AdaptiveMesh {
  public:
    AdaptiveMesh(const AdaptiveMesh&) = delete;  // the default midpoint rule refers to the mesh
    AdaptiveMesh& operator=(const AdaptiveMesh&) = delete;
    ~AdaptiveMesh() = default;

    /// The roots, unrefined. \p positions holds one position a root vertex. \p midpoint_rule defaults to the
    /// mean of the ends.
    AdaptiveMesh(RootComplex roots, std::vector<glm::vec3> positions, MidpointRule midpoint_rule = {});

    Index leaf_count() const { return static_cast<Index>(leaves_.size()); }
    Index vertex_count() const { return static_cast<Index>(positions_.size()); }
    const RootComplex& roots() const { return roots_; }
    std::span<const glm::vec3> positions() const { return positions_; }

    const Triangle& vertices(Index leaf) const { return leaves_[leaf].vertices; }

    /// Neighbours of \p leaf across the edges opposite its three vertices; no_index at the boundary.
    const Triangle& neighbours(Index leaf) const { return leaves_[leaf].neighbours; }

    unsigned level(Index leaf) const { return leaves_[leaf].level; }

    /// The way from the root to \p leaf: bit n is set where the bisection of level n went to the second
    /// child.
    std::uint64_t path(Index leaf) const { return leaves_[leaf].path; }

    /// Bisects every leaf in \p marked at least once and closes: the smallest conforming refinement that does
    /// (algorithm (A)). \return the leaves that changed or are new, each at least once; valid until the next
    /// call \throw InputError before a leaf would pass max_level; the mesh is then conforming, with a part of
    /// \p marked refined
    std::span<const Index> refine(std::span<const Index> marked);

    /// Number of leaves that refine() of \p leaf alone would add. Changes nothing but scratch memory.
    Index leaves_added_by(Index leaf);

    /// All leaves, root after root, in the preorder of their trees.
    std::vector<Index> preorder() const;

    /// The frozen hierarchy of the present leaves.
    Hierarchy freeze() const;

    /// Every violation of the mesh's own invariants (neighbours mutual and edge-matched, levels, order), one
    /// sentence each; for tests. What makes the frozen hierarchy sound is in checker.h.
    std::vector<std::string> violations() const;

  private:
    struct LeafRecord {
        Triangle vertices;
        Triangle neighbours;
        Index next;  ///< the next leaf in preorder, no_index after the last
        std::uint8_t level;
        bool in_chain;  ///< only while a chain is collected
        std::uint64_t path;
    };
    struct Pending {
        Index leaf;
        std::uint8_t level;
    };

    bool is_compatible(Index leaf) const;
    std::size_t collect_chain(Index leaf);
    void require_levels(std::size_t cycle_begin) const;
    void bisect_with_closure(Index leaf);
    void bisect_pair(Index leaf);
    void bisect_cycle(std::span<const Index> cycle);
    Index split(Index leaf, Index midpoint);
    void link(Index a, unsigned side_a, Index b, unsigned side_b);
    void redirect(Index leaf, Index from, Index to);
    Index add_midpoint(Index leaf);

    RootComplex roots_;
    std::vector<LeafRecord> leaves_;
    std::vector<glm::vec3> positions_;
    MidpointRule midpoint_rule_;
    std::vector<Index> chain_;
    std::vector<Index> changed_;
    std::vector<Pending> pending_;
};

}  // namespace interleaf
