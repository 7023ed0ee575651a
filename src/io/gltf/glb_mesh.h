// A union of keys as a glTF mesh: attributes of the base key, and a morph target per other key.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "hierarchy/field.h"
#include "hierarchy/progress.h"
#include "hierarchy/union_mesh.h"
#include "io/gltf/glb_builder.h"
#include "io/gltf/target_normals.h"

namespace interleaf {

/// The attribute of each field: the color field `color`, or else the first color, is COLOR_0, and other
/// colors follow as COLOR_1 and so on; a scalar is its name in capital letters after a low line. Each is
/// unique.
std::vector<std::string> attribute_names(std::span<const UnionField> fields);

/// The size of the arrays that add_primitive() would add, in bytes.
std::uint64_t primitive_size(const UnionMesh& mesh);

/// \throw InputError if primitive_size() is above \p max_size
void require_primitive_size(const UnionMesh& mesh, std::uint64_t max_size = max_glb_size);

/// Adds the arrays of \p mesh with its fields to \p builder.
/// \param base   index of the base among the keys of \p mesh; the others become targets, in their order
/// \param pairs  keys that are blended with each other (target_normals.h)
/// \return       the only element of the mesh's `primitives`, with material 0
/// \throw        Cancelled when \p progress says so
nlohmann::ordered_json add_primitive(GlbBuilder& builder, const UnionMesh& mesh, std::size_t base,
                                     std::span<const KeyPair> pairs, const Progress& progress = {});

}  // namespace interleaf
