// A mesh of a glTF file with its morph targets: primitives joined, nothing welded yet.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/field.h"
#include "hierarchy/triangle.h"
#include "io/gltf/gltf_arrays.h"
#include "io/gltf/gltf_scene.h"

namespace interleaf {

/// A color or a scalar per vertex.
struct GltfAttribute {
    std::string name;  ///< "COLOR_0", "_HEIGHT"
    FieldKind kind = FieldKind::scalar;
    std::vector<float> values;               ///< of the base; colors are linear light, without alpha
    std::vector<std::vector<float>> deltas;  ///< per target
};

struct GltfMesh {
    std::vector<glm::dvec3> positions;           ///< of the base, in the world
    std::vector<Triangle> triangles;             ///< name existing vertices
    std::vector<std::vector<glm::vec3>> deltas;  ///< per target, what it adds to the positions
    std::vector<GltfAttribute> attributes;       ///< that all primitives have
    std::vector<std::string> remarks;            ///< sentences about what was passed over
};

/// The number of morph targets of mesh \p mesh.
std::size_t target_count(const GltfFile& file, std::size_t mesh);

/// Joins all primitives of \p instances. Points and lines are passed over.
/// \pre   all meshes have the same number of targets
/// \throw InputError naming the place and what was expected
GltfMesh read_meshes(const GltfFile& file, std::span<const MeshInstance> instances);

}  // namespace interleaf
