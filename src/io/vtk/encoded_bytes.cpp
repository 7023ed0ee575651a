#include "io/vtk/encoded_bytes.h"

#include <algorithm>
#include <cstdint>

namespace interleaf {
namespace {

constexpr unsigned not_a_digit = 64;

/// The value of each character as a digit of base 64 (RFC 4648, table 1).
constexpr std::array<std::uint8_t, 256> digit_values = [] {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::uint8_t, 256> values{};
    values.fill(not_a_digit);
    for (std::size_t n = 0; n < digits.size(); ++n)
        values[static_cast<unsigned char>(digits[n])] = static_cast<std::uint8_t>(n);
    return values;
}();

bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

}  // namespace

std::size_t EncodedBytes::available() const {
    if (form_ == Form::raw) return rest_.size();
    return group_end_ - group_begin_ + rest_.size() / 4 * 3;
}

bool EncodedBytes::read(std::span<std::byte> bytes) {
    if (bytes.size() > available()) return false;
    if (form_ == Form::raw) {
        const auto source = std::as_bytes(std::span(rest_.substr(0, bytes.size())));
        std::ranges::copy(source, bytes.begin());
        rest_.remove_prefix(bytes.size());
        return true;
    }
    for (std::byte& byte : bytes) {
        if (group_begin_ == group_end_ && !decode_group()) return false;
        byte = group_[group_begin_++];
    }
    return true;
}

/// Decodes the next four characters.
bool EncodedBytes::decode_group() {
    std::uint32_t bits = 0;
    std::size_t digits = 0;
    std::size_t padding = 0;
    while (digits + padding < 4) {
        if (rest_.empty()) return false;
        const char c = rest_.front();
        rest_.remove_prefix(1);
        const std::uint8_t digit = digit_values[static_cast<unsigned char>(c)];
        if (c == '=') {
            ++padding;
        } else if (digit != not_a_digit && padding == 0) {
            bits = bits << 6U | digit;
            ++digits;
        } else if (!is_blank(c)) {
            return false;
        }
    }
    if (digits < 2) return false;
    bits <<= 6 * padding;
    for (unsigned n = 0; n < 3; ++n) group_[n] = static_cast<std::byte>(bits >> (16 - 8 * n));
    group_begin_ = 0;
    group_end_ = digits - 1;
    return true;
}

}  // namespace interleaf
