#include "fuzz/allocation_count.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#include "sanitized.h"
#include <malloc.h>
#include <sys/mman.h>

#ifdef INTERLEAF_ADDRESS_SANITIZER
// From sanitizer/allocator_interface.h. g++ has these functions, but not the header.
extern "C" {
int __sanitizer_install_malloc_and_free_hooks(void (*allocated)(const volatile void*, std::size_t),
                                              void (*released)(const volatile void*));
std::size_t __sanitizer_get_allocated_size(const volatile void* memory);
}
#endif

namespace interleaf::fuzz {

namespace {

std::ptrdiff_t allocated = 0;  // negative if memory from before the count is freed
std::ptrdiff_t at_begin = 0;
std::ptrdiff_t max_allocated = 0;

void count(std::ptrdiff_t bytes) {
    allocated += bytes;
    max_allocated = std::max(max_allocated, allocated);
}

}  // namespace

void begin_count() {
    at_begin = allocated;
    max_allocated = allocated;
}

std::size_t max_bytes() {
    return static_cast<std::size_t>(max_allocated - at_begin);
}

}  // namespace interleaf::fuzz

// The linker option --wrap=NAME leads calls of NAME to __wrap_NAME, and calls of __real_NAME to NAME.
extern "C" {

void* __real_mmap(void* place, std::size_t bytes, int protection, int flags, int file, off_t offset);
int __real_munmap(void* memory, std::size_t bytes);
void* __real_mremap(void* memory, std::size_t old_bytes, std::size_t new_bytes, int flags, ...);

void* __wrap_mmap(void* place, std::size_t bytes, int protection, int flags, int file, off_t offset) {
    void* const memory = __real_mmap(place, bytes, protection, flags, file, offset);
    if (memory != MAP_FAILED) interleaf::fuzz::count(static_cast<std::ptrdiff_t>(bytes));
    return memory;
}

int __wrap_munmap(void* memory, std::size_t bytes) {
    const int result = __real_munmap(memory, bytes);
    if (result == 0) interleaf::fuzz::count(-static_cast<std::ptrdiff_t>(bytes));
    return result;
}

// Called only with MREMAP_FIXED, so it replaces a mapping that has been counted.
void* __wrap_mremap(void* memory, std::size_t old_bytes, std::size_t new_bytes, int flags, void* place) {
    void* const moved = __real_mremap(memory, old_bytes, new_bytes, flags, place);
    if (moved != MAP_FAILED) interleaf::fuzz::count(-static_cast<std::ptrdiff_t>(old_bytes));
    return moved;
}

}  // extern "C"

#ifdef INTERLEAF_ADDRESS_SANITIZER

namespace {

void count_allocation(const volatile void*, std::size_t bytes) {
    interleaf::fuzz::count(static_cast<std::ptrdiff_t>(bytes));
}

void count_release(const volatile void* memory) {
    interleaf::fuzz::count(-static_cast<std::ptrdiff_t>(__sanitizer_get_allocated_size(memory)));
}

[[maybe_unused]] const int installed =
    __sanitizer_install_malloc_and_free_hooks(&count_allocation, &count_release);

}  // namespace

// Every build wraps these functions. In this build, the sanitizer counts.
extern "C" {
void* __real_malloc(std::size_t bytes);
void __real_free(void* memory);
void* __wrap_malloc(std::size_t bytes) {
    return __real_malloc(bytes);
}
void __wrap_free(void* memory) {
    __real_free(memory);
}
}

#else

extern "C" {

void* __real_malloc(std::size_t bytes);
void __real_free(void* memory);

void* __wrap_malloc(std::size_t bytes) {
    void* const memory = __real_malloc(bytes);
    interleaf::fuzz::count(static_cast<std::ptrdiff_t>(::malloc_usable_size(memory)));
    return memory;
}

void __wrap_free(void* memory) {
    interleaf::fuzz::count(-static_cast<std::ptrdiff_t>(::malloc_usable_size(memory)));
    __real_free(memory);
}

}  // extern "C"

void* operator new(std::size_t bytes) {
    if (void* const memory = std::malloc(std::max<std::size_t>(bytes, 1))) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

#endif
