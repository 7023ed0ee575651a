#include "app/cli/shown_text.h"

#include <algorithm>
#include <cstddef>

#include <fmt/core.h>

namespace interleaf {
namespace {

unsigned char code(char c) {
    return static_cast<unsigned char>(c);
}

/// Bytes of the character that \p text begins with, by the table of well-formed UTF-8 (Unicode 15, table
/// 3-7); 0 if it begins with none.
std::size_t character_length(std::string_view text) {
    const unsigned char first = code(text[0]);
    if (first < 0x80) return 1;
    if (first < 0xc2 || first > 0xf4) return 0;
    const std::size_t length = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    if (text.size() < length) return 0;
    const auto follows = [](char c) { return (code(c) & 0xc0) == 0x80; };
    if (!std::ranges::all_of(text.substr(1, length - 1), follows)) return 0;
    const unsigned char second = code(text[1]);
    const bool is_overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool is_surrogate = first == 0xed && second >= 0xa0;
    const bool is_beyond = first == 0xf4 && second >= 0x90;
    return is_overlong || is_surrogate || is_beyond ? 0 : length;
}

/// Control characters of ASCII, and those from U+0080 to U+009F, which terminals obey as well.
bool is_control(std::string_view character) {
    const unsigned char first = code(character[0]);
    return first < 0x20 || first == 0x7f || (first == 0xc2 && code(character[1]) < 0xa0);
}

}  // namespace

std::string shown_text(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        if (length > 0 && !is_control(character))
            result += character;
        else
            for (const char c : character) result += fmt::format("\\x{:02x}", code(c));
        text.remove_prefix(character.size());
    }
    return result;
}

}  // namespace interleaf
