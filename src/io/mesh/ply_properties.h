// The properties of PLY vertices that hold the fields of a key.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "family/field_scale.h"
#include "hierarchy/field.h"

namespace interleaf {

/// A property for one component of a field: a byte, 0 to 255, for a color; a float for a scalar, or a double if the
/// scalar has an offset.
struct PlyProperty {
    std::string name;  ///< letters, digits and '_'; unique
    bool is_byte;
    const Field* field;
    std::size_t component;
    double offset = 0;  ///< is added to the values

    const char* type() const { return is_byte ? "uchar" : offset == 0 ? "float" : "double"; }
};

/// The properties of \p fields, in the order of the fields.
/// \param vertex_colors  one of \p fields, or null: the properties of this field are called red, green and
///                       blue, which is where other programs look for colors
/// \param scales         the offsets of the fields
std::vector<PlyProperty> ply_properties(std::span<const Field> fields, const Field* vertex_colors,
                                        std::span<const FieldScale> scales = {});

}  // namespace interleaf
