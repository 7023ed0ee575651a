// Bytes inside a VTK XML file: as they are, or in base 64.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace interleaf {

/// Reads the bytes of a text from front to back. In base 64, blanks are skipped, and padding ends a group but
/// not the bytes: writers encode the header of a block and its data separately.
class EncodedBytes {
  public:
    enum class Form { raw, base64 };

    EncodedBytes(std::string_view text, Form form) : rest_(text), form_(form) {}

    /// At least the number of bytes that are left.
    std::size_t available() const;

    /// Fills \p bytes.
    /// \return whether there were enough bytes
    bool read(std::span<std::byte> bytes);

  private:
    bool decode_group();

    std::string_view rest_;
    Form form_;
    std::array<std::byte, 3> group_{};  ///< decoded bytes that were not yet read
    std::size_t group_begin_ = 0;
    std::size_t group_end_ = 0;
};

}  // namespace interleaf
