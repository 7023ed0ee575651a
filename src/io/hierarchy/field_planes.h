// The fields of a key as byte planes. Each component of a field is a column of numbers. Three columns at a
// time are predicted and stored like positions (position_planes.h). Zeros fill the last group of three.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hierarchy/buffer.h"
#include "hierarchy/field.h"
#include "io/hierarchy/bisection_decisions.h"

namespace interleaf {

/// The number of bytes of the planes of \p fields over \p vertex_count vertices.
std::size_t field_planes_size(std::span<const FieldName> fields, std::size_t vertex_count);

/// The planes of \p fields, group after group of three columns.
Buffer<std::byte> field_planes(std::span<const Field> fields, const Connectivity& connectivity);

/// The fields with the names and kinds \p labels.
/// \param planes  the planes of the fields, field_planes_size() bytes
/// \throw InputError unless zeros fill the last group of columns
std::vector<Field> fields_of(std::span<std::byte> planes, std::span<const FieldName> labels,
                             const Connectivity& connectivity);

}  // namespace interleaf
