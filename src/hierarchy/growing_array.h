// An array of plain values. Once it is large, it grows at its end without copying its content. The arrays of
// a mesh under refinement are of this type.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <type_traits>

#include "hierarchy/large_memory.h"

namespace interleaf {

template <typename T>
class GrowingArray {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    GrowingArray() = default;
    explicit GrowingArray(std::span<const T> values) {
        reserve(values.size());
        std::copy(values.begin(), values.end(), data_);
        size_ = values.size();
    }
    GrowingArray(const GrowingArray&) = delete;
    GrowingArray& operator=(const GrowingArray&) = delete;
    ~GrowingArray() { free_memory(data_, capacity_ * sizeof(T)); }

    std::size_t size() const { return size_; }
    std::size_t byte_count() const { return size_ * sizeof(T); }
    T& operator[](std::size_t place) {
        assert(place < size_);
        return data_[place];
    }
    const T& operator[](std::size_t place) const {
        assert(place < size_);
        return data_[place];
    }
    std::span<const T> span() const { return {data_, size_}; }

    void push_back(T value) {
        const std::size_t place = append();
        data_[place] = value;
    }

    /// Adds an uninitialized value.
    /// \return its place
    std::size_t append() {
        if (size_ == capacity_) grow();
        return size_++;
    }
    void pop_back() { --size_; }
    T& back() { return data_[size_ - 1]; }
    bool empty() const { return size_ == 0; }
    void clear() { size_ = 0; }

  private:
    /// Doubles the size. An array that is no longer small gets a huge page at once.
    void grow() {
        constexpr std::size_t small = 64 << 10, huge = 2 << 20;
        const std::size_t bytes = std::max<std::size_t>(2 * capacity_ * sizeof(T), 1 << 10);
        reserve((bytes > small ? std::max(bytes, huge) : bytes) / sizeof(T));
    }
    void reserve(std::size_t capacity) {
        data_ = static_cast<T*>(grow_memory(data_, capacity_ * sizeof(T), capacity * sizeof(T)));
        capacity_ = capacity;
    }

    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

}  // namespace interleaf
