// How often tests at random try.
#pragma once

namespace interleaf {

/// \p count; a quarter of it under the sanitizers: these are slow, and what they look for shows in fewer
/// cases.
constexpr unsigned trials(unsigned count) {
#ifdef __SANITIZE_ADDRESS__
    return count / 4;
#else
    return count;
#endif
}

}  // namespace interleaf
