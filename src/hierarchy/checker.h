// The checker: one function that states every invariant of a hierarchy. Tests call it, `interleaf check`
// calls it, and every reader calls it on the content of a file.
//
// A hierarchy is sound if
//   1. its preorder bits describe exactly one tree per root, at most max_level deep, with no bits left over;
//   2. its vertices are numbered by first visit, and none is missing;
//   3. every midpoint is the midpoint of one edge: its second visit comes from the other side of the edge of
//      its first visit, there is no third visit, and only an edge on the boundary of the surface is visited
//      once;
//   4. its positions are finite;
//   5. it has at most max_field_count fields; their names differ and pass is_field_name(); each field has
//      finite values for every vertex, and a color has values from 0 to 1.
//
// Invariant 3 is conformity: a hanging node is a midpoint that is visited once away from the boundary. Two
// consequences follow. The leaves are a manifold with the orientation, Euler number and boundary of the root
// complex. Leaves that share an edge differ by at most two levels, and by at most one under a compatible
// marking. docs/theory.md has the proofs; the tests check the consequences on the leaf mesh itself.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// Every violation in \p hierarchy, one sentence per violation, each naming the place. The result is empty if
/// the hierarchy is sound.
///
/// The checker never reads outside the arrays, whatever they hold. It stops after \p limit violations, or at
/// the first one that makes the rest unreadable. It takes time proportional to the number of nodes.
std::vector<std::string> check(const Hierarchy& hierarchy, std::size_t limit = 20);

/// How \p other differs from \p first as a root complex: in its counts, or in the first root triangle with
/// different vertices or a different refinement edge. Empty if the two are the same.
std::string difference(const RootComplex& first, const RootComplex& other);

/// Checks constraints (B) over several keys (paper, section 3.2): all have the same root complex, vertex for
/// vertex and refinement edge for refinement edge. Each violation names a key by its number, and the root
/// triangle or vertex count that differs from the first key's.
std::vector<std::string> check_constraints(std::span<const Hierarchy* const> keys);

}  // namespace interleaf
