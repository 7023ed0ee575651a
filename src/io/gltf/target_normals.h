// Normals of morph targets. A glTF viewer blends normals linearly and normalizes the sum, but the normals of
// a blend are a quadratic form in the weights (vertex_normals.h). So each key's normals get lengths: a blend
// of two keys half and half, with the right ratio of lengths, has the exact normal as nearly as the two
// normals can give it. Each vertex has as many ratios as there are pairs of keys that are blended, and fewer
// lengths, so the lengths are a mean. docs/file-formats.md has the angles that are left.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/progress.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

/// Two keys of a union, as indices.
using KeyPair = std::array<std::size_t, 2>;

struct TargetNormals {
    std::vector<glm::vec3> base;                 ///< unit vectors
    std::vector<std::vector<glm::vec3>> deltas;  ///< per key, what it adds to them; empty for the base
};

/// The normals of \p mesh for glTF.
///
/// Blender shows a triangle as flat if the normals of all its corners are its own normal, and then ignores
/// the normals of the targets. The base normals of such corners are therefore tilted by 0.002.
/// \param base   index of the base
/// \param pairs  keys that are blended with each other, each pair once, of two different keys
/// \throw Cancelled when \p progress says so
TargetNormals target_normals(const UnionMesh& mesh, std::size_t base, std::span<const KeyPair> pairs,
                             const Progress& progress = {});

}  // namespace interleaf
