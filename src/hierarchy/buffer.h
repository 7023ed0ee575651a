// A vector in memory for large arrays, whose resize() leaves new elements uninitialized. It suits arrays that
// are written right after resize(), and reused from call to call. 16 bytes from the start of any element are
// readable, even from the start of the last one.
#pragma once

#include <cstddef>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include "hierarchy/large_memory.h"

namespace interleaf {

template <typename T>
struct BufferAllocator {
    using value_type = T;
    static constexpr std::size_t readable_behind = 16;

    BufferAllocator() = default;
    template <typename Other>
    explicit BufferAllocator(const BufferAllocator<Other>&) {}

    T* allocate(std::size_t count) {
        if (count >= std::numeric_limits<std::size_t>::max() / sizeof(T) - readable_behind)
            throw std::bad_array_new_length();
        return static_cast<T*>(allocate_memory(count * sizeof(T) + readable_behind));
    }
    void deallocate(T* memory, std::size_t count) {
        free_memory(memory, count * sizeof(T) + readable_behind);
    }

    template <typename Other>
    void construct(Other* place) {
        ::new (static_cast<void*>(place)) Other;
    }
    template <typename Other, typename... Arguments>
    void construct(Other* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
    }

    bool operator==(const BufferAllocator&) const { return true; }
};

template <typename T>
using Buffer = std::vector<T, BufferAllocator<T>>;

}  // namespace interleaf
