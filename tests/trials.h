// How often tests at random try.
#pragma once

#include "sanitized.h"

namespace interleaf {

/// \p count; a quarter of it under the sanitizers: these are slow, and what they look for shows in fewer
/// cases.
constexpr unsigned trials(unsigned count) {
    return is_sanitized ? count / 4 : count;
}

}  // namespace interleaf
