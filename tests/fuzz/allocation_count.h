// Counts the memory that this program allocates with new, malloc and mmap, in all code that is linked
// statically. Link options in CMakeLists.txt lead malloc and mmap here. For one thread only.
#pragma once

#include <cstddef>

namespace interleaf::fuzz {

void begin_count();

/// The peak of the allocated bytes since begin_count(), minus the bytes that were allocated then.
std::size_t max_bytes();

}  // namespace interleaf::fuzz
