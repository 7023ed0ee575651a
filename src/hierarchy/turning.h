// The turning blend: parts of the surface that turn from key to key turn on the way, where the weighted sum of
// positions would shrink them (docs/theory.md has the proofs).
//
// Each vertex gets a rotation from every key to every other one, smooth over the surface (turning_rotations.h). A
// blend first averages rotations: at a vertex, A_k is the rotation from key k to the weighted mean of the keys, the
// normalized sum over j of b_j q_kj, where the quaternion q_kj rotates from k to j. An edge e of the blend then
// wants to be the sum over k of b_k A_k e_k, with A_k averaged over its ends. One least-squares system, factorized
// once per union, finds the positions whose edges are closest to that. At a key its A_k is the identity and no edge
// is in conflict, so the blend is the key. A key of weight 0 has no part in any of this.
//
// In the least squares every leaf counts as an isosceles right triangle with its refinement edge as the
// hypotenuse, the shape that bisection reproduces. So the system depends on the leaves alone, leaves of no area do
// no harm, and a flat part counts the same however it is bisected.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include <glm/vec3.hpp>

#include "hierarchy/buffer.h"

namespace interleaf {

struct UnionMesh;

class Turning {
  public:
    /// The rotations are those of pairs of keys, so their number grows with the square of the number of keys.
    static constexpr std::size_t max_keys = 8;

    /// \param first  the first key that blends: the keys before it only refine the leaves
    /// \pre  at most max_keys keys blend
    explicit Turning(const UnionMesh& mesh, std::size_t first = 0);

    /// Writes one position per union vertex.
    /// \param mesh     the union that this was made of
    /// \param weights  one per key, used as given; each component of the roots keeps the center of its weighted sum
    /// \pre  keys that do not blend have the weight 0
    void blend(const UnionMesh& mesh, std::span<const float> weights, Buffer<glm::vec3>& positions) const;

    /// Memory of the large arrays, in bytes.
    std::size_t byte_count() const;

  private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};

}  // namespace interleaf
