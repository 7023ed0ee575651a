// A button that opens a list of keys to choose one from.
#pragma once

#include <cstddef>
#include <optional>

#include "family/family.h"

namespace interleaf {

/// Offers the keys of \p family that are not active in \p weights.
/// \return the chosen key
std::optional<std::size_t> key_picker(const char* label, const Family& family, const Weights& weights,
                                      float width);

}  // namespace interleaf
