// Welds the vertices of a glTF mesh that were split for the sake of attributes, and drops unused vertices.
#pragma once

#include <cstddef>

#include "io/gltf/gltf_mesh.h"

namespace interleaf {

/// Replaces vertices by the first vertex with the same positions in the base and in all targets, then drops
/// triangles that have lost a corner.
/// \return the number of triangles dropped
std::size_t weld_vertices(GltfMesh& mesh);

/// Drops the vertices that no triangle uses, and keeps the order of the others.
void drop_unused_vertices(GltfMesh& mesh);

}  // namespace interleaf
