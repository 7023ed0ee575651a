// The morph (paper, theorem 2, equation (3)): H(b) = sum of b_i H_i over the keys of a union, for any real
// weights b, used as given.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

/// The weighted sum of the position streams, one position a union vertex. \p weights has one weight a key of
/// \p mesh.
std::vector<glm::vec3> morph(const UnionMesh& mesh, std::span<const float> weights);

/// The same into \p positions, whose memory is used again.
void morph(const UnionMesh& mesh, std::span<const float> weights, std::vector<glm::vec3>& positions);

/// \p sum[v] = sum over s of weights[s] * streams[s][v], for streams of one length, at least one.
void weighted_sum(std::span<const Buffer<glm::vec3>> streams, std::span<const float> weights,
                  std::vector<glm::vec3>& sum);

/// The interpolated hierarchy H(b) as a key like any other (paper, section 3.3).
Hierarchy morphed_hierarchy(const UnionMesh& mesh, std::span<const float> weights);

}  // namespace interleaf
