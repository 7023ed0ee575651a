// The meshes of a glTF scene with the places where its nodes put them.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/mat4x4.hpp>

#include "io/gltf/gltf_file.h"

namespace interleaf {

struct MeshInstance {
    std::size_t mesh;   ///< index in `meshes`
    glm::dmat4 matrix;  ///< from the mesh to the world
};

/// The meshes of the scene that the file shows, in the order of its nodes. Without scenes, the nodes that are
/// no children count; without nodes, each mesh as it is.
/// \throw InputError naming the node and what was expected; for example, if a node has two parents
std::vector<MeshInstance> mesh_instances(const GltfFile& file);

}  // namespace interleaf
