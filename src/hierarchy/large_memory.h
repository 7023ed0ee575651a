// Memory for large arrays.
//
// The first touch of a page causes a page fault, which costs about the same for a huge page of 2 MiB as for a
// page of 4 KiB. On virtual machines a fault costs many times what filling the page costs. So large blocks
// get mappings of their own and ask for huge pages, and they grow by moving page tables instead of bytes.
// Untouched pages take no memory.
#pragma once

#include <cstddef>

namespace interleaf {

/// \p bytes uninitialized bytes, aligned for any type.
/// \throw std::bad_alloc
void* allocate_memory(std::size_t bytes);

/// Frees \p memory of \p bytes bytes. Accepts nullptr with 0 bytes.
void free_memory(void* memory, std::size_t bytes);

/// Enlarges \p memory from \p old_bytes to \p new_bytes; it may move. The old bytes keep their values, the
/// new ones are uninitialized.
/// \throw std::bad_alloc, and leaves \p memory unchanged
void* grow_memory(void* memory, std::size_t old_bytes, std::size_t new_bytes);

}  // namespace interleaf
