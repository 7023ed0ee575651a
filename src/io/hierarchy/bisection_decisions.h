// The connectivity of a hierarchy in its shortest form: which nodes are bisected, said only where it is open.
//
// In preorder, a node is bisected for certain when one of its edges has got a midpoint from the triangles on
// the other side, or the midpoint would hang; and it is a leaf for certain when its refinement edge belongs
// to a leaf on the other side. Only for the rest is a decision kept, a byte 0 or 1: fewer than one a leaf.
// The midpoints need not be kept at all: the second visit of an edge finds the vertex that the first one
// made. What is rebuilt conforms, whatever the decisions are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hierarchy/buffer.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

/// The edge of a midpoint and the two triangles about it; no_index for what a root vertex, or the boundary,
/// has not.
struct MidpointStar {
    std::array<Index, 2> ends;    ///< of the edge
    std::array<Index, 2> apexes;  ///< opposite it, on the side visited first and on the other
};

struct Connectivity {
    Buffer<std::uint64_t> bits;  ///< as in Hierarchy
    Buffer<Index> midpoints;     ///< as in Hierarchy
    Buffer<MidpointStar> stars;  ///< one a vertex
    Buffer<std::uint8_t>
        levels;  ///< one a vertex: of the children that its first visit made; 0 for a root vertex
};

struct DecidedConnectivity {
    Buffer<std::byte> decisions;
    Connectivity connectivity;
};

/// The open decisions of a hierarchy that has passed check().
DecidedConnectivity open_decisions(const Hierarchy& hierarchy);

/// What \p decisions make of \p roots. Memory is used as far as the decisions go, whatever the counts say.
/// \throw InputError unless they fit each other, leaves are at most max_level deep, and there are \p
/// midpoint_count bisected nodes and \p vertex_count vertices
Connectivity rebuilt_connectivity(const RootComplex& roots, Index midpoint_count, Index vertex_count,
                                  std::span<const std::byte> decisions);

}  // namespace interleaf
