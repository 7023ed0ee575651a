// Numbers of things as a person types them, on the command line or into a field.
#pragma once

#include <optional>
#include <string_view>

#include "hierarchy/triangle.h"

namespace interleaf {

/// The whole of \p text as a number of things: "20000", and "2e4" or "1.5e6" where that is a whole number;
/// none otherwise.
std::optional<Index> typed_count(std::string_view text);

}  // namespace interleaf
