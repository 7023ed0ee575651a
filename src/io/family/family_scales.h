// The offsets and units of fields, and the unit of time, in family.json.
#pragma once

#include <string>
#include <vector>

#include "family/field_scale.h"
#include "family/timeline.h"
#include "io/text/json_place.h"

namespace interleaf {

/// A unit of a field or of time, as people write it.
/// \throw InputError naming the place and what was expected
std::string written_unit_at(const JsonPlace& place);

/// The member `unit` of the timeline at \p place, which version 1 does not have.
/// \throw InputError naming the place and what was expected
TimeUnit unit_at(const JsonPlace& place, double version);

/// The member `scales`: offsets and units of fields.
/// \throw InputError naming the place and what was expected
std::vector<FieldScale> scales_at(const JsonPlace& place);

}  // namespace interleaf
