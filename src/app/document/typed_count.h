// Counts as a person types them, on the command line or into a text field.
#pragma once

#include <optional>
#include <string_view>

#include "hierarchy/triangle.h"

namespace interleaf {

/// The count that \p text as a whole gives: "20000", or "2e4" and "1.5e6", whose values are whole numbers.
/// None otherwise.
std::optional<Index> typed_count(std::string_view text);

}  // namespace interleaf
