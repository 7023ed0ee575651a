// The connectivity of a hierarchy in its shortest form: one decision, bisected or not, per open node.
//
// The walk visits nodes in preorder. A node must be bisected if one of its edges already has a midpoint from
// the triangles on the other side, because that midpoint would hang otherwise. A node must be a leaf if its
// refinement edge belongs to a leaf on the other side. All other nodes are open, and a decision is stored for
// each, as a byte 0 or 1. There are fewer open nodes than leaves. Midpoints are not stored, because the
// second visit of an edge finds the vertex that the first visit made. The rebuilt hierarchy conforms,
// whatever the decisions are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hierarchy/buffer.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

/// The edge of a midpoint and the apexes of the two triangles at that edge. A root vertex has no_index
/// everywhere; a midpoint on the boundary has no_index as its second apex.
struct MidpointStar {
    std::array<Index, 2> ends;    ///< of the edge
    std::array<Index, 2> apexes;  ///< opposite the edge: on the side visited first, and on the other side
};

struct Connectivity {
    Buffer<std::uint64_t> bits;  ///< as in Hierarchy
    Buffer<Index> midpoints;     ///< as in Hierarchy
    Buffer<MidpointStar> stars;  ///< one per vertex

    /// One per vertex: the level of the children that its first visit made; 0 for a root vertex.
    Buffer<std::uint8_t> levels;
};

struct DecidedConnectivity {
    Buffer<std::byte> decisions;
    Connectivity connectivity;
};

/// The open decisions of \p hierarchy.
/// \pre \p hierarchy has passed check()
DecidedConnectivity open_decisions(const Hierarchy& hierarchy);

/// The connectivity that \p decisions give over \p roots. The function uses memory only as far as the
/// decisions go, whatever the counts say.
/// \throw InputError unless the decisions fit each other, all leaves are at most max_level deep, and there
///                   are \p midpoint_count bisected nodes and \p vertex_count vertices
Connectivity rebuilt_connectivity(const RootComplex& roots, Index midpoint_count, Index vertex_count,
                                  std::span<const std::byte> decisions);

}  // namespace interleaf
