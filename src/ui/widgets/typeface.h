// The typeface of the user interface, Inter (SIL Open Font License 1.1), as embedded by embed_typeface.cmake.
#pragma once

#include <span>

namespace interleaf {

/// The bytes of the OpenType file.
std::span<const unsigned char> typeface();

}  // namespace interleaf
