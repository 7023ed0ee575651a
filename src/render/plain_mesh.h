// Any indexed triangle mesh as the renderer draws it, beside keys or without any.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/union_mesh.h"

namespace interleaf {

/// A union of one key with \p triangles as leaves of level 0. It need be neither closed nor a manifold, so
/// there are no roots behind it: no edge is one of theirs, and it is good for nothing but being drawn.
/// \p positions holds one a vertex.
UnionMesh plain_mesh(std::span<const Triangle> triangles, std::span<const glm::vec3> positions);

}  // namespace interleaf
