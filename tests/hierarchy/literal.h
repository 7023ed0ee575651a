// Slow, literal versions from the paper, with which the fast ones must agree. They share no code with them
// but the bisection rule of triangle.h.
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

/// A node of the infinite complex of theorem 1: a root and the way down, bit n the child taken at level n.
struct Node {
    std::size_t root;
    unsigned level;
    std::uint64_t path;
    auto operator<=>(const Node&) const = default;

    Node child(unsigned which) const { return {root, level + 1, path | std::uint64_t{which} << level}; }
    /// \pre  not a root
    Node parent() const { return {root, level - 1, path & ~(std::uint64_t{1} << (level - 1))}; }
};

/// The infinite complex over some roots, its vertices named on demand: every edge has one midpoint, whichever
/// side asks.
class InfiniteComplex {
  public:
    explicit InfiniteComplex(const RootComplex& roots) : roots_(&roots), next_(roots.vertex_count()) {}

    Index midpoint(Index a, Index b);
    /// The midpoint of an edge if anyone has asked for it, no_index otherwise.
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

/// The nodes of leaves that are given in preorder by their levels.
std::vector<Node> nodes_of_levels(const std::vector<unsigned>& levels);

/// Algorithm (A) in passes, as the paper states it: bisects \p marked, then all non-conforming triangles,
/// until there are none.
std::set<Node> rivara(InfiniteComplex& complex, std::set<Node> leaves, const std::set<Node>& marked);

/// The midpoints that coarsening removes when the leaves \p marked are marked: one set for each step, most of
/// one midpoint.
///
/// Triangles can be leaves again when their children are leaves. So a midpoint needs those gone at which a
/// child of a triangle bisected at it is bisected, and those that these need in turn. It goes alone when it
/// needs none. The midpoints of a cycle need each other, and nothing else: they go together. In both cases
/// all leaves that have one of them as vertex must be marked.
std::set<std::set<Index>> coarsening_steps(InfiniteComplex& complex, const std::set<Node>& leaves,
                                           const std::set<Node>& marked);

/// The leaves when the triangles bisected at the midpoints of \p steps are leaves again.
std::set<Node> coarsened(InfiniteComplex& complex, const std::set<Node>& leaves,
                         const std::set<std::set<Index>>& steps);

/// What is wrong with \p leaves as a conforming triangulation over the roots: an edge of more than two
/// triangles, of two in the same direction, of one away from the boundary; a wrong Euler number; neighbours
/// more than \p level_difference levels apart. Empty when nothing is.
std::vector<std::string> triangulation_violations(InfiniteComplex& complex, const std::vector<Node>& leaves,
                                                  unsigned level_difference);

}  // namespace interleaf::testing
