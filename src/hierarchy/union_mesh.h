// The union of hierarchies (paper, theorem 2 and section 3.3, figures 6 and 7): the smallest hierarchy that
// contains several keys over one root complex, as an indexed mesh of its leaves with one position stream a
// key.
//
// One synchronous walk over the preorder streams, each read once, front to back. A node of the union is
// bisected where any key bisects it. The midpoint of its refinement edge (a, b) gets, in a key that is
// bisected here, that key's own vertex, and in every other key the mean of that key's values at a and b: this
// is what composing the level maps of equation (1) gives (docs/theory.md has the proof, the tests compare
// with the literal composition).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/buffer.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// What a union leaf carries besides its vertices, packed in 32 bits.
///
/// Corner exponents: the weight of the leaf at its corner c in a vertex normal is 2^corner_exponent(c); see
/// vertex_normals.h.
class LeafTag {
  public:
    LeafTag() = default;
    constexpr LeafTag(unsigned level, unsigned root_edges, std::array<unsigned, 3> exponents)
        : packed_(level | root_edges << 7 | exponents[0] << 10 | exponents[1] << 17 | exponents[2] << 24) {}

    /// Bisections above the leaf, 0 to max_level.
    constexpr unsigned level() const { return packed_ & 0x7f; }

    /// Whether the edge opposite vertex \p corner (0 to 2) lies on an edge of the root complex.
    constexpr bool on_root_edge(unsigned corner) const { return (packed_ >> (7 + corner) & 1) != 0; }

    /// Binary logarithm of the weight of corner 0, 1 or 2.
    constexpr unsigned corner_exponent(unsigned corner) const { return packed_ >> (10 + 7 * corner) & 0x7f; }

    /// Bits 0-6 the level, bits 7-9 on_root_edge(0..2), then the three exponents in 7 bits each.
    constexpr std::uint32_t packed() const { return packed_; }

    /// The tags of the children (l, k, i) and (l, i, j) of a triangle (i, j, k) with this tag: opposite their
    /// vertices lie the edges (ki, il, lk) and (ij, jl, li). See vertex_normals.h for the exponents.
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

    std::uint32_t packed_;  // left uninitialised by default: tags fill large buffers
};

/// Set of active keys as bits: bit i for the i-th key given to unite(); those numbered 31 and up share
/// bit 31.
using KeySet = std::uint32_t;

constexpr KeySet key_bit(std::size_t key) {
    return KeySet{1} << (key < 31 ? key : 31);
}

/// How a vertex of the union came to be.
struct VertexOrigin {
    std::array<Index, 2> edge;  ///< the ends of the edge it bisects; {no_index, no_index} for a root vertex
    KeySet keys;                ///< the keys in which it is a vertex of their own, not a mean
};

/// A field of the union: a stream a key beside the positions. See union_fields.h.
struct UnionField {
    FieldName label;
    std::vector<Buffer<float>> values;  ///< values[key]: as in a Field, but colours in linear light
};

struct UnionMesh {
    RootComplex roots;
    Buffer<Triangle> triangles;     ///< leaves in preorder; refinement edge opposite the first vertex
    Buffer<LeafTag> tags;           ///< one a triangle
    Buffer<KeySet> origins;         ///< one a triangle: the keys in which it is a node, bisected this far
    Buffer<VertexOrigin> vertices;  ///< root vertices, then midpoints by first visit, after their edge's ends
    std::vector<Buffer<glm::vec3>> positions;  ///< positions[key][vertex]
    std::vector<Buffer<Index>>
        own_vertices;                  ///< own_vertices[key][v]: the key's vertex v in the union, ascending
    std::vector<UnionField> fields{};  ///< as far as unite_fields() was asked for them

    std::size_t leaf_count() const { return triangles.size(); }
    std::size_t vertex_count() const { return vertices.size(); }
    std::size_t key_count() const { return positions.size(); }
};

/// The union of \p keys, any number from one, without their fields (see unite_fields()).
/// \throw InputError if their root complexes differ (constraints (B))
/// \pre  each key passes check()
UnionMesh unite(std::span<const Hierarchy* const> keys);

/// The same into the buffers of \p mesh, whose memory is used again.
void unite(std::span<const Hierarchy* const> keys, UnionMesh& mesh);

}  // namespace interleaf
