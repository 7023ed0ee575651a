// The checker: one function that states every invariant of a hierarchy. Tests call it, `interleaf check`
// calls it, and every reader calls it on what a file claims.
//
// A hierarchy is sound when
//   1. its preorder bits describe exactly one tree for each root, at most max_level deep, nothing left over;
//   2. its vertices are numbered by first visit, and none is missing;
//   3. every midpoint is the midpoint of one edge: its second visit comes from the other side of the edge it
//   was first
//      visited on, there is no third, and only an edge on the boundary of the surface is visited once;
//   4. its positions are finite;
//   5. its fields, at most max_field_count, have names that differ and is_field_name() accepts, and finite
//   values for every vertex, those of a colour from 0 to 1.
// Conformity is 3 (a hanging node is a midpoint visited once away from the boundary). It follows that the
// leaves are a manifold with the orientation, Euler number and boundary of the root complex, and that leaves
// that share an edge differ by at most two levels, by one under a compatible marking: docs/theory.md has the
// proofs, the tests check these consequences on the leaf mesh itself.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// Every violation found in \p hierarchy, one sentence each that names the place; empty when it is sound. It
/// never reads outside the arrays, whatever they hold, and stops after \p limit violations, or at the first
/// that leaves the rest unreadable. Takes time proportional to the nodes.
std::vector<std::string> check(const Hierarchy& hierarchy, std::size_t limit = 20);

/// How \p other differs from \p first as a root complex: in its counts, or in the first root triangle whose
/// vertices or refinement edge are others. Empty when they are the same.
std::string difference(const RootComplex& first, const RootComplex& other);

/// Constraints (B) over several keys (paper, section 3.2): the same root complex, vertex for vertex and
/// refinement edge for refinement edge. Each violation names a key by its number and the root triangle or
/// vertex count that differs from the first key's.
std::vector<std::string> check_constraints(std::span<const Hierarchy* const> keys);

}  // namespace interleaf
