// Characters of UTF-8, and the tests that every name and every text from outside must pass. All layers ask
// here, so that a name that one of them accepts is a name for the others.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace interleaf {

struct Character {
    char32_t code;     ///< the code point
    std::size_t size;  ///< bytes in UTF-8
};

/// The character that \p text begins with, by the table of well-formed UTF-8 (Unicode 15, table 3-7; RFC
/// 3629). None if \p text begins with a character that is cut off, longer than necessary, a surrogate or
/// beyond Unicode.
/// \pre  \p text is not empty
std::optional<Character> first_character(std::string_view text);

/// Appends the character \p code, at most 0x10ffff, in UTF-8. A surrogate gets three bytes, too.
void append_character(std::string& text, char32_t code);

/// Whether \p byte continues a character of UTF-8, so that no text may be cut in front of it.
constexpr bool continues_character(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80;
}

/// Whether \p code is a control character: one of ASCII, or one from U+0080 to U+009F, which terminals obey
/// as well.
constexpr bool is_control(char32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0);
}

bool is_utf8(std::string_view text);

/// Whether \p text is UTF-8 without control characters, so that it can be shown on one line and moves no
/// terminal's cursor. Names of families, keys and fields must be. An empty text is printable.
bool is_printable(std::string_view text);

/// \p text without the spaces, tabs and ends of lines around it.
std::string_view without_blanks(std::string_view text);

/// \p text in lower case, letter by letter. Bytes that are not UTF-8 stay as they are.
std::string folded(std::string_view text);

}  // namespace interleaf
