// The triangle hierarchy in its frozen form: what a key is, in memory and on disk (paper, section 2.1).
//
// The forest of bisected root triangles is written in preorder: for each node one bit (1 bisected, 0 leaf)
// and for each bisected node the index of the vertex at the middle of its refinement edge. Children follow
// their parent in the stream and their triples are those of bisect(), so there are no child, parent or
// sibling references: about 10.25 bytes a leaf, positions included.
//
// Vertices are numbered: those of the root complex in its order, then midpoints by their first visit in
// preorder. check() in checker.h states every invariant; a Hierarchy that has passed it is conforming.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/buffer.h"
#include "hierarchy/field.h"
#include "hierarchy/root_complex.h"
#include "hierarchy/triangle.h"

namespace interleaf {

struct Hierarchy {
    RootComplex roots;
    Buffer<std::uint64_t> bits;   ///< preorder bits, lowest bit of the first word first; unused bits are 0
    Buffer<Index> midpoints;      ///< vertex of each bisected node, in preorder
    Buffer<glm::vec3> positions;  ///< one a vertex
    std::vector<Field> fields{};  ///< each with values for every vertex

    std::size_t vertex_count() const { return positions.size(); }
    std::size_t leaf_count() const { return roots.triangle_count() + midpoints.size(); }
    std::size_t node_count() const { return roots.triangle_count() + 2 * midpoints.size(); }

    /// Whether the node at \p position of the preorder is bisected.
    bool is_bisected(std::size_t position) const { return (bits[position / 64] >> (position % 64) & 1) != 0; }

    /// Memory of the arrays, in bytes, the root complex included.
    std::size_t byte_count() const;
};

/// A leaf as the preorder yields it.
struct Leaf {
    Triangle vertices;
    std::uint8_t level;  ///< bisections above it; 0 for a root that is a leaf
};

/// The hierarchy whose leaves, root after root in preorder, are \p leaves.
///
/// The levels alone determine the forest and the triples its midpoints, so this freezes an adaptive mesh and
/// a union alike. Vertices are renumbered by first visit; \p positions and \p fields are indexed by the
/// numbers used in \p leaves, root vertices first. \pre  the leaves are those of a conforming refinement of
/// \p roots
Hierarchy hierarchy_from_leaves(const RootComplex& roots, const std::vector<Leaf>& leaves,
                                std::span<const glm::vec3> positions, std::span<const Field> fields = {});

/// The leaves of a hierarchy that has passed check(), in preorder.
std::vector<Leaf> leaves_of(const Hierarchy& hierarchy);

/// The root complex alone, not bisected, as a hierarchy. \p positions holds one position a root vertex.
Hierarchy unrefined(const RootComplex& roots, const std::vector<glm::vec3>& positions);

}  // namespace interleaf
