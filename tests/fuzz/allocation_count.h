// Counts what this program asks memory for: new, malloc and mmap of all that is linked into it statically.
// Linked with the options of CMakeLists.txt that lead malloc and mmap here. One thread only.
#pragma once

#include <cstddef>

namespace interleaf::fuzz {

void begin_count();

/// The most bytes that were allocated at one time since begin_count(), beyond those that were allocated then.
std::size_t max_bytes();

}  // namespace interleaf::fuzz
