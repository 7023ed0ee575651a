// Whether this program runs under AddressSanitizer, which takes its time and its memory.
#pragma once

#if defined(__has_feature)  // clang
#if __has_feature(address_sanitizer)
#define INTERLEAF_ADDRESS_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)  // g++
#define INTERLEAF_ADDRESS_SANITIZER
#endif

namespace interleaf {

#ifdef INTERLEAF_ADDRESS_SANITIZER
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

}  // namespace interleaf
