// The offsets and units of fields in family.json.
#pragma once

#include <string>
#include <vector>

#include "family/field_scale.h"
#include "io/text/json_place.h"

namespace interleaf {

/// A unit of a field or of time, as people write it.
/// \throw InputError naming the place and what was expected
std::string written_unit_at(const JsonPlace& place);

/// The member `scales`: offsets and units of fields.
/// \throw InputError naming the place and what was expected
std::vector<FieldScale> scales_at(const JsonPlace& place);

}  // namespace interleaf
