// The fields of a key as byte planes. All their components are columns of numbers; three columns at a time
// are predicted and told apart like positions (position_planes.h). Zeros fill the last three up.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hierarchy/buffer.h"
#include "hierarchy/field.h"
#include "io/hierarchy/bisection_decisions.h"

namespace interleaf {

/// Bytes of the planes of \p fields over \p vertex_count vertices.
std::size_t field_planes_size(std::span<const FieldName> fields, std::size_t vertex_count);

/// The planes of \p fields, those of each three columns together.
Buffer<std::byte> field_planes(std::span<const Field> fields, const Connectivity& connectivity);

/// The fields \p labels whose planes are \p planes, field_planes_size() bytes.
/// \throw InputError if it is not zeros that fill the last columns up
std::vector<Field> fields_of(std::span<std::byte> planes, std::span<const FieldName> labels,
                             const Connectivity& connectivity);

}  // namespace interleaf
