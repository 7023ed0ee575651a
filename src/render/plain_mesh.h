// Any indexed triangle mesh in the form that the renderer draws, beside keys or on its own.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/union_mesh.h"

namespace interleaf {

/// A union of one key with \p triangles as leaves of level 0. The mesh need be neither closed nor a manifold.
/// It has no roots, so none of its edges is a root edge, and the union is suitable only for drawing.
/// \param positions  one per vertex
UnionMesh plain_mesh(std::span<const Triangle> triangles, std::span<const glm::vec3> positions);

}  // namespace interleaf
