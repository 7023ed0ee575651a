#include "text/characters.h"

#include <algorithm>
#include <cwctype>

#include <locale.h>

namespace interleaf {

namespace {

/// Bytes of a character whose first one is \p first; 0 if no character begins so.
std::size_t size_after(unsigned char first) {
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first < 0xe0) return 2;
    if (first >= 0xe0 && first < 0xf0) return 3;
    if (first >= 0xf0 && first < 0xf5) return 4;
    return 0;
}

char32_t lower_case(char32_t code) {
    if (code < 0x80) return code >= 'A' && code <= 'Z' ? code + ('a' - 'A') : code;
    // The program's own locale knows ASCII only. Where there is no C.UTF-8, other letters keep their case.
    static const locale_t unicode = ::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
    if (unicode == nullptr) return code;
    return static_cast<char32_t>(::towlower_l(static_cast<wint_t>(code), unicode));
}

/// Whether \p text is UTF-8 of characters that \p is_allowed accepts.
template <typename IsAllowed>
bool consists_of(std::string_view text, IsAllowed is_allowed) {
    while (!text.empty()) {
        const auto character = first_character(text);
        if (!character || !is_allowed(character->code)) return false;
        text.remove_prefix(character->size);
    }
    return true;
}

}  // namespace

std::optional<Character> first_character(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t size = size_after(first);
    if (size == 0 || size > text.size()) return std::nullopt;
    if (size == 1) return Character{.code = first, .size = 1};
    char32_t code = first & (0xffU >> (size + 1));
    for (const char byte : text.substr(1, size - 1)) {
        if (!continues_character(byte)) return std::nullopt;
        code = code << 6 | (static_cast<unsigned char>(byte) & 0x3fU);
    }
    constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = code >= 0xd800 && code < 0xe000;
    if (code < smallest[size] || is_surrogate || code > 0x10ffff) return std::nullopt;
    return Character{.code = code, .size = size};
}

void append_character(std::string& text, char32_t code) {
    const auto continue_with = [&](int shift) {
        text += static_cast<char>(0x80U | ((code >> shift) & 0x3fU));
    };
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xc0U | code >> 6);
        continue_with(0);
    } else if (code < 0x10000) {
        text += static_cast<char>(0xe0U | code >> 12);
        continue_with(6);
        continue_with(0);
    } else {
        text += static_cast<char>(0xf0U | code >> 18);
        continue_with(12);
        continue_with(6);
        continue_with(0);
    }
}

bool is_utf8(std::string_view text) {
    return consists_of(text, [](char32_t) { return true; });
}

bool is_printable(std::string_view text) {
    return consists_of(text, [](char32_t code) { return !is_control(code); });
}

std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::string folded(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const auto character = first_character(text);
        if (character) {
            append_character(result, lower_case(character->code));
        } else {
            result += text.front();
        }
        text.remove_prefix(character ? character->size : 1);
    }
    return result;
}

}  // namespace interleaf
