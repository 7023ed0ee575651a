// The triangle hierarchy in its frozen form: what a key is, in memory and on disk (paper, section 2.1).
//
// The forest of bisected root triangles is stored in preorder. Each node has one bit (1 bisected, 0 leaf),
// and each bisected node has the index of the vertex at the middle of its refinement edge. Children follow
// their parent in the stream and their triples are those of bisect(), so there are no child, parent or
// sibling references. This takes about 10.25 bytes per leaf, positions included.
//
// Vertices are numbered as follows: first those of the root complex in its order, then midpoints by their
// first visit in preorder. check() in checker.h states every invariant; a Hierarchy that has passed it is
// conforming.
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
    Buffer<glm::vec3> positions;  ///< one per vertex
    std::vector<Field> fields{};  ///< each with values for every vertex

    std::size_t vertex_count() const { return positions.size(); }
    std::size_t leaf_count() const { return roots.triangle_count() + midpoints.size(); }
    std::size_t node_count() const { return roots.triangle_count() + 2 * midpoints.size(); }

    /// Whether the node at \p position in the preorder is bisected.
    bool is_bisected(std::size_t position) const { return (bits[position / 64] >> (position % 64) & 1) != 0; }

    /// Memory of the arrays in bytes, including the root complex.
    std::size_t byte_count() const;
};

/// A leaf, as the preorder yields it.
struct Leaf {
    Triangle vertices;
    std::uint8_t level;  ///< number of bisections above it; 0 for a root that is a leaf
};

/// The hierarchy whose leaves, root after root in preorder, are \p leaves.
///
/// The levels alone determine the forest, and the triples determine its midpoints. So this function freezes
/// an adaptive mesh and a union alike. It renumbers vertices by first visit.
/// \param positions  indexed by the vertex numbers that \p leaves use, root vertices first
/// \param fields     indexed likewise
/// \pre  the leaves are those of a conforming refinement of \p roots
Hierarchy hierarchy_from_leaves(const RootComplex& roots, const std::vector<Leaf>& leaves,
                                std::span<const glm::vec3> positions, std::span<const Field> fields = {});

/// The leaves, in preorder, of a hierarchy that has passed check().
std::vector<Leaf> leaves_of(const Hierarchy& hierarchy);

/// The unrefined root complex as a hierarchy.
/// \param positions  one per root vertex
Hierarchy unrefined(const RootComplex& roots, const std::vector<glm::vec3>& positions);

}  // namespace interleaf
