// How the triangles of a root complex are glued together, in a form that suits the comparison of two
// complexes: the side across each side, the surroundings of each vertex, the connected components, and
// signatures of sides.
//
// Sides are numbered 3 t + k: side k of triangle t, opposite its vertex k. An isomorphism that keeps the
// orientation is determined by the image of one side per component (docs/theory.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hierarchy/root_complex.h"

namespace interleaf {

struct RootGluing {
    std::span<const Triangle> triangles;  ///< the triangles of the complex, which must outlive this
    std::vector<Index> across;            ///< by side: the same edge as a side of the neighbor, or no_index
    /// By vertex: twice the number of triangles around it, plus 1 on the boundary.
    std::vector<Index> surroundings;
    /// The triangles, component after component; the component with the lowest triangle comes first.
    std::vector<Index> order;
    std::vector<Index> begins;      ///< where each component begins in `order`, then the size of `order`
    std::vector<Index> components;  ///< component of each triangle

    Index component_count() const { return static_cast<Index>(begins.size()) - 1; }
    std::span<const Index> component(Index c) const {
        return std::span(order).subspan(begins[c], begins[c + 1] - begins[c]);
    }
    /// The vertex opposite \p side.
    Index apex(Index side) const { return triangles[side / 3][side % 3]; }
};

/// The side \p k places after \p side around its triangle.
constexpr Index turned(Index side, Index k) {
    return side - side % 3 + (side % 3 + k) % 3;
}

/// The gluing of \p roots.
/// \throw InputError if there are too many sides to be numbered
RootGluing gluing_of(const RootComplex& roots);

/// A number per side that depends only on how the complex looks from that side, up to \p radius triangles
/// away, including refinement edges if \p marked. So sides that an isomorphism maps to each other have the
/// same number. Sides that look different have different numbers, except by chance.
std::vector<std::uint64_t> signatures(const RootGluing& gluing, bool marked, unsigned radius);

}  // namespace interleaf
