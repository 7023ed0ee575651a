// Rows of three numbers, stored as planes of bytes: all lowest bytes of the first column, then all second
// bytes of that column, and so on. The numbers are differences from expected values. Signed differences
// become unsigned numbers (0, -1, 1, -2, ... become 0, 1, 2, 3, ...), so small differences give small
// numbers, and nearly all bytes of the high planes are zero.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace interleaf {

class BytePlanes {
  public:
    static constexpr std::size_t columns = 3;
    static constexpr std::size_t bytes_a_row = columns * sizeof(std::uint32_t);

    /// The planes in \p bytes, which holds bytes_a_row bytes per row.
    explicit BytePlanes(std::span<std::byte> bytes) : bytes_(bytes), rows_(bytes.size() / bytes_a_row) {}

    std::size_t rows() const { return rows_; }

    /// Differences are taken modulo 2^32.
    void set_difference(std::size_t row, std::size_t column, std::uint32_t difference) const {
        const std::uint32_t number = difference << 1 ^ (0U - (difference >> 31));
        for (std::size_t n = 0; n < 4; ++n)
            bytes_[(4 * column + n) * rows_ + row] = static_cast<std::byte>(number >> (8 * n));
    }
    std::uint32_t difference(std::size_t row, std::size_t column) const {
        std::uint32_t number = 0;
        for (std::size_t n = 0; n < 4; ++n)
            number |= std::to_integer<std::uint32_t>(bytes_[(4 * column + n) * rows_ + row]) << (8 * n);
        return number >> 1 ^ (0U - (number & 1));
    }

  private:
    std::span<std::byte> bytes_;
    std::size_t rows_;
};

}  // namespace interleaf
