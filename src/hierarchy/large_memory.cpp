#include "hierarchy/large_memory.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace interleaf {

namespace {

#ifdef __linux__

constexpr std::size_t huge_page = std::size_t{2} << 20;

/// From this size on, a block uses at least half of its huge page.
constexpr std::size_t large = huge_page / 2;

constexpr std::size_t in_whole_pages(std::size_t bytes) {
    return (bytes + huge_page - 1) / huge_page * huge_page;
}

/// A mapping of \p bytes bytes. They are a multiple of huge_page and the mapping is aligned to it: huge pages
/// need both.
void* map(std::size_t bytes) {
    void* const wider = ::mmap(nullptr, bytes + huge_page, PROT_READ | PROT_WRITE,
                               MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (wider == MAP_FAILED) throw std::bad_alloc();
    char* const begin = static_cast<char*>(wider);
    const std::size_t before =
        in_whole_pages(reinterpret_cast<std::uintptr_t>(begin)) - reinterpret_cast<std::uintptr_t>(begin);
    if (before > 0) ::munmap(begin, before);
    ::munmap(begin + before + bytes, huge_page - before);
    ::madvise(begin + before, bytes, MADV_HUGEPAGE);  // a failure only makes it slower
    return begin + before;
}

/// Moves a mapping with its pages into a wider one.
void* widen(void* memory, std::size_t old_bytes, std::size_t new_bytes) {
    void* const place = map(new_bytes);
    if (::mremap(memory, old_bytes, new_bytes, MREMAP_MAYMOVE | MREMAP_FIXED, place) == MAP_FAILED) {
        ::munmap(place, new_bytes);
        throw std::bad_alloc();
    }
    return place;
}

#endif

void* allocate_small(std::size_t bytes) {
    void* const memory = std::malloc(bytes);
    if (memory == nullptr && bytes > 0) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* allocate_memory(std::size_t bytes) {
#ifdef __linux__
    if (bytes >= large) return map(in_whole_pages(bytes));
#endif
    return allocate_small(bytes);
}

void free_memory(void* memory, std::size_t bytes) {
#ifdef __linux__
    if (bytes >= large) {
        ::munmap(memory, in_whole_pages(bytes));
        return;
    }
#endif
    static_cast<void>(bytes);
    std::free(memory);
}

void* grow_memory(void* memory, std::size_t old_bytes, std::size_t new_bytes) {
#ifdef __linux__
    if (old_bytes >= large) return widen(memory, in_whole_pages(old_bytes), in_whole_pages(new_bytes));
#endif
    void* const larger = allocate_memory(new_bytes);
    if (old_bytes > 0) std::memcpy(larger, memory, old_bytes);
    free_memory(memory, old_bytes);
    return larger;
}

}  // namespace interleaf
