// How the triangles of a root complex hang together, in the form in which two complexes are compared: what
// lies across each side, what is around each vertex, the connected components, and signatures of sides.
//
// A side is numbered 3 t + k: side k of triangle t, opposite its vertex k. An isomorphism that keeps the
// orientation is known by the image of one side in each component (docs/theory.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hierarchy/root_complex.h"

namespace interleaf {

struct RootGluing {
    std::span<const Triangle> triangles;  ///< those of the complex, which must outlive this
    std::vector<Index> across;            ///< by side: the same edge as a side of the neighbour, or no_index
    std::vector<Index> surroundings;      ///< by vertex: twice the triangles around it, and 1 on the boundary
    std::vector<Index> order;       ///< the triangles, component after component, by their lowest triangle
    std::vector<Index> begins;      ///< where the components begin in order, and at the end its size
    std::vector<Index> components;  ///< by triangle

    Index component_count() const { return static_cast<Index>(begins.size()) - 1; }
    std::span<const Index> component(Index c) const {
        return std::span(order).subspan(begins[c], begins[c + 1] - begins[c]);
    }
    /// The vertex opposite a side.
    Index apex(Index side) const { return triangles[side / 3][side % 3]; }
};

/// The side \p k places further round the triangle of \p side.
constexpr Index turned(Index side, Index k) {
    return side - side % 3 + (side % 3 + k) % 3;
}

/// \throw InputError if the sides are too many to be numbered
RootGluing gluing_of(const RootComplex& roots);

/// A number for each side that depends on nothing but how the complex looks from there, up to \p radius
/// triangles away, with refinement edges if \p marked. So sides that an isomorphism maps to each other have
/// the same one; sides that look different have different ones but for chance.
std::vector<std::uint64_t> signatures(const RootGluing& gluing, bool marked, unsigned radius);

}  // namespace interleaf
