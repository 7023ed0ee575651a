// Counts what this program asks memory for: new, malloc and mmap of all that is linked into it statically.
// Linked with the options of CMakeLists.txt that lead malloc and mmap here. One thread only.
#pragma once

#include <cstddef>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define INTERLEAF_ADDRESS_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define INTERLEAF_ADDRESS_SANITIZER
#endif

namespace interleaf::fuzz {

/// Whether this program runs under AddressSanitizer, which takes its time.
#ifdef INTERLEAF_ADDRESS_SANITIZER
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

void begin_count();

/// The most bytes that were allocated at one time since begin_count(), beyond those that were allocated then.
std::size_t most_bytes();

}  // namespace interleaf::fuzz
