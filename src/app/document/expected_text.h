// The error of a text that a person gave, on the command line or through the clipboard, and that means nothing.
#pragma once

#include <string_view>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {

/// \param what  what is expected in the place of \p text
/// \throw UsageError  always
[[noreturn]] inline void fail_expecting(std::string_view what, std::string_view text) {
    throw UsageError(fmt::format("expected {}, got '{}'", what, text));
}

}  // namespace interleaf
