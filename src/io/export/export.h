// What is exported: the one description that every writer of a format gets (formats.h).
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "family/family.h"
#include "io/file/output_target.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

/// A writer of one blend takes blend_of(). A writer of the whole family takes the keys and their timeline.
struct Export {
    const Family& family;
    std::optional<Weights>
        weights;                ///< of the blend that was chosen; none where a family has no default blend
    HierarchyFileOptions form;  ///< of keys
};

/// Writes an export in one format.
/// \throw UsageError    where the export lacks what the format needs
/// \throw MachineError  when it cannot be written
using ExportWriter = void (*)(const Export& exported, const OutputTarget& target);

/// One blend of a family: the union of the active keys, and what blends on it.
struct Blend {
    UnionMesh mesh;               ///< with the fields that the active keys have in common
    std::vector<float> weights;   ///< one per key of the union
    Buffer<glm::vec3> positions;  ///< one per vertex of the union, relative to the family's origin
    std::vector<Field> fields;    ///< one value per vertex of the union
};

/// What is wrong with an export of one blend of a family that has no default blend.
inline constexpr const char* no_default_blend = "the family has no timeline; say --at or --weights";

/// The blend of \p exported.
/// \throw UsageError where no weights are given, or they lead out of the range of floats
Blend blend_of(const Export& exported);

}  // namespace interleaf
