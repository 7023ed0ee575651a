// A vector whose resize() leaves new elements uninitialised: for large arrays that are written right after,
// and used again from call to call.
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace interleaf {

template <typename T>
struct UninitializedAllocator : std::allocator<T> {
    template <typename Other>
    struct rebind {
        using other = UninitializedAllocator<Other>;
    };

    template <typename Other>
    void construct(Other* place) {
        ::new (static_cast<void*>(place)) Other;
    }
    template <typename Other, typename... Arguments>
    void construct(Other* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
    }
};

template <typename T>
using Buffer = std::vector<T, UninitializedAllocator<T>>;

}  // namespace interleaf
