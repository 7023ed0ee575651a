// The properties that the fields of a key become at the vertices of a PLY file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "hierarchy/field.h"

namespace interleaf {

/// A component of a field: a byte, 0 to 255, for a color's, a float for a scalar.
struct PlyProperty {
    std::string name;  ///< letters, digits and '_'; unique
    bool is_byte;
    const Field* field;
    std::size_t component;
};

/// The properties of \p fields, in their order. The colors \p vertex_colors, one of them or null, are red,
/// green and blue, as other programs look for them.
std::vector<PlyProperty> ply_properties(std::span<const Field> fields, const Field* vertex_colors);

}  // namespace interleaf
