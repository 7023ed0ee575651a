// The options by which recent series were imported, as the settings keep them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include <nlohmann/json_fwd.hpp>

#include "app/importing/series_import.h"
#include "io/text/json_place.h"

namespace interleaf {

/// ImportChoices::every is below it in the dialog and in the settings.
inline constexpr std::size_t every_limit = std::numeric_limits<std::uint32_t>::max();

/// Units are not kept: they belong to the family, which has them after the import. Names and paths that JSON cannot
/// hold, as they are no UTF-8, are left out.
/// \pre choices.every is below every_limit
nlohmann::ordered_json import_json(const ImportChoices& choices);

/// The choices that import_json() has written.
/// \throw InputError naming the place and what was expected
ImportChoices import_choices_at(const JsonPlace& place);

}  // namespace interleaf
