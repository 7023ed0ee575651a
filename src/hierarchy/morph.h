// The morph (paper, theorem 2, equation (3)): H(b) = sum of b_i H_i over the keys of a union, for any real
// weights b, used as given; of positions and of fields.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

/// The weighted sum of the position streams, one position a union vertex. \p weights has one weight a key of
/// \p mesh.
Buffer<glm::vec3> morph(const UnionMesh& mesh, std::span<const float> weights);

/// The same into \p positions, whose memory is used again.
void morph(const UnionMesh& mesh, std::span<const float> weights, Buffer<glm::vec3>& positions);

/// \p sum[v] = sum over s of weights[s] * streams[s][v], for streams of one length, at least one.
void weighted_sum(std::span<const Buffer<glm::vec3>> streams, std::span<const float> weights,
                  Buffer<glm::vec3>& sum);

/// The weighted sum of the streams of \p field into \p values: as in a Field, but colours as linear light.
void morph(const UnionField& field, std::span<const float> weights, Buffer<float>& values);

/// The morph of \p field, one value a union vertex. Colours are encoded again; where weights led out of 0 to
/// 1, they stop there.
Field morphed_field(const UnionField& field, std::span<const float> weights);

/// The interpolated hierarchy H(b) as a key like any other (paper, section 3.3), with the fields of \p mesh.
Hierarchy morphed_hierarchy(const UnionMesh& mesh, std::span<const float> weights);

}  // namespace interleaf
