// The union of hierarchies (paper, theorem 2 and section 3.3, figures 6 and 7): the smallest hierarchy that
// contains several keys over one root complex. It is stored as an indexed mesh of its leaves with one
// position stream per key.
//
// One synchronous walk reads each preorder stream once, front to back. A node of the union is bisected if any
// key bisects it. Let m be the midpoint of its refinement edge (a, b). A key that is bisected here
// contributes its own vertex at m; every other key contributes the mean of its values at a and b. This is
// what the composition of the level maps of equation (1) gives: docs/theory.md has the proof, the tests
// compare with the literal composition.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/buffer.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/triangle.h"
#include "hierarchy/turning.h"

namespace interleaf {

/// What a union leaf carries besides its vertices, packed in 32 bits.
///
/// The leaf has the weight 2^corner_exponent(c) at its corner c in a vertex normal; see vertex_normals.h.
class LeafTag {
  public:
    LeafTag() = default;
    constexpr LeafTag(unsigned level, unsigned root_edges, std::array<unsigned, 3> exponents)
        : packed_(level | root_edges << 7 | exponents[0] << 10 | exponents[1] << 17 | exponents[2] << 24) {}

    /// Number of bisections above the leaf, 0 to max_level.
    constexpr unsigned level() const { return packed_ & 0x7f; }

    /// Whether the edge opposite vertex \p corner (0 to 2) lies on an edge of the root complex.
    constexpr bool on_root_edge(unsigned corner) const { return (packed_ >> (7 + corner) & 1) != 0; }

    /// Binary logarithm of the weight of corner 0, 1 or 2.
    constexpr unsigned corner_exponent(unsigned corner) const { return packed_ >> (10 + 7 * corner) & 0x7f; }

    /// Bits 0-6 the level, bits 7-9 on_root_edge(0..2), then the three exponents in 7 bits each.
    constexpr std::uint32_t packed() const { return packed_; }

    /// The tags of the children (l, k, i) and (l, i, j) of a triangle (i, j, k) with this tag. The edges
    /// opposite their vertices are (ki, il, lk) and (ij, jl, li). For the exponents see vertex_normals.h.
    constexpr std::array<LeafTag, 2> children() const {
        const std::uint32_t level = (packed_ & 0x7f) + 1;
        const std::uint32_t at_i = packed_ >> 10 & 0x7f;
        const std::uint32_t at_j = packed_ >> 17 & 0x7f;
        const std::uint32_t at_k = packed_ >> 24 & 0x7f;
        const std::uint32_t common = level | level << 10;
        const std::uint32_t first_edges = (packed_ >> 1 & 0x080) | (packed_ << 2 & 0x200);
        const std::uint32_t second_edges = (packed_ >> 2 & 0x080) | (packed_ << 1 & 0x100);
        return {LeafTag(common | first_edges | (at_k + 1) << 17 | at_i << 24),
                LeafTag(common | second_edges | at_i << 17 | (at_j + 1) << 24)};
    }

  private:
    explicit constexpr LeafTag(std::uint32_t packed) : packed_(packed) {}

    std::uint32_t packed_;  // uninitialized by default: tags fill large buffers
};

/// A set of active keys as bits: bit i for the i-th key given to unite(). Keys numbered 31 and up share bit
/// 31.
using KeySet = std::uint32_t;

constexpr KeySet key_bit(std::size_t key) {
    return KeySet{1} << (key < 31 ? key : 31);
}

/// The origin of a vertex of the union.
struct VertexOrigin {
    std::array<Index, 2> edge;  ///< the ends of the edge it bisects; {no_index, no_index} for a root vertex
    KeySet keys;                ///< the keys that have this vertex themselves, instead of a mean
};

/// A field of the union: one stream per key, like the positions. See union_fields.h.
struct UnionField {
    FieldName label;
    std::vector<Buffer<float>> values;  ///< values[key]: laid out as in a Field, but colors are linear light
};

struct UnionMesh {
    RootComplex roots;
    Buffer<Triangle> triangles;     ///< leaves in preorder; refinement edge opposite the first vertex
    Buffer<LeafTag> tags;           ///< one per triangle
    Buffer<KeySet> origins;         ///< one per triangle: the keys in which it is a node
    Buffer<VertexOrigin> vertices;  ///< root vertices, then midpoints by first visit, after their edge's ends
    std::vector<Buffer<glm::vec3>> positions;  ///< positions[key][vertex]
    /// own_vertices[key][v]: number in the union of the key's vertex v; ascending in v.
    std::vector<Buffer<Index>> own_vertices;
    std::vector<UnionField> fields{};  ///< the fields that unite_fields() was asked for
    std::optional<Turning> turning{};  ///< how the keys blend; none for the weighted sum of their positions

    std::size_t leaf_count() const { return triangles.size(); }
    std::size_t vertex_count() const { return vertices.size(); }
    std::size_t key_count() const { return positions.size(); }
};

/// The union of \p keys, at least one, without their fields (see unite_fields()).
/// \throw InputError if their root complexes differ (constraints (B))
/// \pre  each key passes check()
UnionMesh unite(std::span<const Hierarchy* const> keys);

/// As above, but reuses the memory of \p mesh.
void unite(std::span<const Hierarchy* const> keys, UnionMesh& mesh);

}  // namespace interleaf
