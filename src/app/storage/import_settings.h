// The options by which recent series were imported, as the settings keep them.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/importing/series_import.h"
#include "io/text/json_place.h"

namespace interleaf {

/// Units are not kept: they belong to the family, which has them after the import.
nlohmann::ordered_json import_json(const ImportChoices& choices);

/// The choices that import_json() has written.
/// \throw InputError naming the place and what was expected
ImportChoices import_choices_at(const JsonPlace& place);

}  // namespace interleaf
