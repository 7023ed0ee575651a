// A triangle and its bisection: the one rule on which everything else rests (paper, section 2.1, figure 4).
//
// The refinement edge of a triangle (i, j, k) is the edge (j, k) opposite its first vertex. Bisection puts a
// new vertex l at the middle of (j, k) and gives the children (l, k, i) and (l, i, j), in that order. So the
// order of the root's vertices determines the refinement edge of every descendant; no marks are stored.
#pragma once

#include <array>
#include <cstdint>

namespace interleaf {

/// Index of a vertex or of a triangle.
using Index = std::uint32_t;

/// No vertex, no triangle.
inline constexpr Index no_index = 0xffffffff;

/// Three vertices, counter-clockwise seen from outside; the refinement edge is opposite the first.
using Triangle = std::array<Index, 3>;

/// Side k of a triangle is the edge opposite its vertex k; side k of triangle t has the number 3 t + k.
///
/// After bisect(), child c has a half of the parent's refinement edge on its side half_side[c], and the edge
/// to its sibling on its side sibling_side[c]. It inherits its side 0 whole: the first child from the
/// parent's side 1, the second from the parent's side 2.
inline constexpr unsigned refinement_side = 0;
inline constexpr std::array<unsigned, 2> half_side = {2, 1};
inline constexpr std::array<unsigned, 2> sibling_side = {1, 2};

/// The maximum level of a leaf. A path from a root to a leaf has one bit per level, so it fits in 64 bits.
inline constexpr unsigned max_level = 64;

/// The children (l, k, i) and (l, i, j) of the triangle (i, j, k) bisected at the midpoint l of (j, k).
constexpr std::array<Triangle, 2> bisect(const Triangle& parent, Index midpoint) {
    const auto [i, j, k] = parent;
    return {{{midpoint, k, i}, {midpoint, i, j}}};
}

/// The inverse of bisect(): the triangle with the children \p first (l, k, i) and \p second (l, i, j).
constexpr Triangle merge(const Triangle& first, const Triangle& second) {
    return {second[1], second[2], first[1]};
}

}  // namespace interleaf
