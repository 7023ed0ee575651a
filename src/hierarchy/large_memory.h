// Memory for large arrays.
//
// The first touch of a page is a fault, which costs about the same for a huge page of 2 MiB as for one of 4
// KiB; on virtual machines that is many times what it costs to fill it. So large blocks are mapped apart and
// ask for huge pages, and they grow by moving page tables, not bytes. What is not touched takes no memory.
#pragma once

#include <cstddef>

namespace interleaf {

/// \p bytes bytes, not initialised, aligned for any type. \throw std::bad_alloc
void* allocate_memory(std::size_t bytes);

/// Gives back \p memory of \p bytes bytes. None at all, nullptr and 0, may be given too.
void free_memory(void* memory, std::size_t bytes);

/// Makes \p memory of \p old_bytes bytes larger; it may move. The bytes keep their values, the new ones have
/// none. \throw std::bad_alloc and leaves it as it was
void* grow_memory(void* memory, std::size_t old_bytes, std::size_t new_bytes);

}  // namespace interleaf
