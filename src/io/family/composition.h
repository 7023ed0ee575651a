// How the keys of a family are blended, as JSON: the members of family.json but for the files of the keys.
// Other formats hold the same members, with the same meaning.
#pragma once

#include <string>

#include "family/family.h"
#include "io/text/json_place.h"

namespace interleaf {

/// A JSON object with the members `version`, `name`, `keys` (their names alone), `timeline`, `domain`,
/// `origin` and `scales` of family.json.
std::string composition_text(const Family& family);

/// Reads the timeline, the parameter domain with its path, the origin, and the offsets and units of fields.
/// \param place   an object with members as composition_text() writes them
/// \param family  has its keys
/// \throw InputError naming the place and what was expected
void read_composition(const JsonPlace& place, Family& family);

}  // namespace interleaf
