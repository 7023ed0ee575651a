// The morph (paper, theorem 2, equation (3)): H(b) = sum of b_i H_i over the keys of a union, of positions
// and of fields. The weights b are any real numbers, used as given. Positions turn instead if the union asks for
// it (turning.h).
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

/// The weighted sum of the position streams, or the turning blend if \p mesh has one.
/// \param weights  one per key of \p mesh
/// \return one position per union vertex
Buffer<glm::vec3> morph(const UnionMesh& mesh, std::span<const float> weights);

/// As above, but reuses the memory of \p positions.
void morph(const UnionMesh& mesh, std::span<const float> weights, Buffer<glm::vec3>& positions);

/// Computes \p sum[v] = sum over s of weights[s] * streams[s][v].
/// \pre  there is at least one stream, and all have the same length
void weighted_sum(std::span<const Buffer<glm::vec3>> streams, std::span<const float> weights,
                  Buffer<glm::vec3>& sum);

/// Writes the weighted sum of the streams of \p field to \p values. Their layout is that of a Field, but
/// colors are linear light.
void morph(const UnionField& field, std::span<const float> weights, Buffer<float>& values);

/// The morph of \p field, one value per union vertex. Colors are encoded again, after clamping to 0 to 1.
Field morphed_field(const UnionField& field, std::span<const float> weights);

/// The interpolated hierarchy H(b), a key like any other (paper, section 3.3), with the fields of \p mesh.
Hierarchy morphed_hierarchy(const UnionMesh& mesh, std::span<const float> weights);

}  // namespace interleaf
