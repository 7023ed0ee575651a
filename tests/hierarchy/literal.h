// Slow, literal versions from the paper, with which the fast versions must agree. The two share no code
// except the bisection rule of triangle.h.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "hierarchy/root_complex.h"

namespace interleaf::testing {

/// A node of the infinite complex of theorem 1: a root and the path down from it. Bit n is the child taken at
/// level n.
struct Node {
    std::size_t root;
    unsigned level;
    std::uint64_t path;
    auto operator<=>(const Node&) const = default;

    Node child(unsigned which) const { return {root, level + 1, path | std::uint64_t{which} << level}; }
    /// \pre  the node is not a root
    Node parent() const { return {root, level - 1, path & ~(std::uint64_t{1} << (level - 1))}; }
};

/// The infinite complex over some roots. It names its vertices on demand: every edge has one midpoint, no
/// matter from which side it is requested.
class InfiniteComplex {
  public:
    explicit InfiniteComplex(const RootComplex& roots) : roots_(&roots), next_(roots.vertex_count()) {}

    Index midpoint(Index a, Index b);
    /// The midpoint of an edge if it has been requested before, no_index otherwise.
    Index known_midpoint(Index a, Index b) const;
    Triangle triangle(const Node& node);
    const RootComplex& roots() const { return *roots_; }

  private:
    const RootComplex* roots_;
    Index next_;
    std::map<std::pair<Index, Index>, Index> midpoints_;
};

/// The nodes that a hierarchy bisects.
std::set<Node> bisected_nodes(const Hierarchy& hierarchy);

/// The leaves of the forest that bisects the nodes \p bisected over \p root_count roots, in preorder.
std::vector<Node> leaf_nodes(const std::set<Node>& bisected, std::size_t root_count);

/// The nodes of the leaves with the given levels, in preorder.
std::vector<Node> nodes_of_levels(const std::vector<unsigned>& levels);

/// Algorithm (A) in passes, as the paper states it: bisects \p marked, then all non-conforming triangles,
/// until there are none.
std::set<Node> rivara(InfiniteComplex& complex, std::set<Node> leaves, const std::set<Node>& marked);

/// The midpoints that coarsening removes if the leaves \p marked are marked: one set per step, usually with
/// one midpoint.
///
/// Triangles can become leaves again if their children are leaves. So the removal of a midpoint requires the
/// removal of each midpoint at which a child of a triangle bisected at it is bisected, and of their
/// requirements in turn. A midpoint without requirements is removed alone. The midpoints of a cycle require
/// each other and nothing else, so they are removed together. In both cases, all leaves that have one of the
/// midpoints as a vertex must be marked.
std::set<std::set<Index>> coarsening_steps(InfiniteComplex& complex, const std::set<Node>& leaves,
                                           const std::set<Node>& marked);

/// The leaves after the triangles bisected at the midpoints of \p steps have become leaves again.
std::set<Node> coarsened(InfiniteComplex& complex, const std::set<Node>& leaves,
                         const std::set<std::set<Index>>& steps);

/// Violations of a conforming triangulation over the roots by \p leaves: an edge of more than two triangles,
/// an edge of two triangles in the same direction, an edge of one triangle away from the boundary, a wrong
/// Euler number, and neighbors whose levels differ by more than \p level_difference. Empty if there are
/// none.
std::vector<std::string> triangulation_violations(InfiniteComplex& complex, const std::vector<Node>& leaves,
                                                  unsigned level_difference);

}  // namespace interleaf::testing
