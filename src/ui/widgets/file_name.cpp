#include "ui/widgets/file_name.h"

#include <algorithm>
#include <cstdint>
#include <cwctype>
#include <optional>

#include <fmt/core.h>
#include <locale.h>

namespace interleaf {

namespace {

struct Character {
    char32_t code;
    std::size_t size;  ///< bytes
};

std::size_t size_after(unsigned char first) {
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first < 0xe0) return 2;
    if (first >= 0xe0 && first < 0xf0) return 3;
    if (first >= 0xf0 && first < 0xf5) return 4;
    return 0;
}

/// The character that \p text begins with; none if that is not UTF-8: cut off, longer than it need be, a
/// surrogate or beyond Unicode.
std::optional<Character> first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t size = size_after(byte(0));
    if (size == 0 || size > text.size()) return std::nullopt;
    if (size == 1) return Character{.code = byte(0), .size = 1};
    char32_t code = byte(0) & (0xffU >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0U) != 0x80) return std::nullopt;
        code = code << 6 | (byte(i) & 0x3fU);
    }
    constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = code >= 0xd800 && code < 0xe000;
    if (code < smallest[size] || is_surrogate || code > 0x10ffff) return std::nullopt;
    return Character{.code = code, .size = size};
}

bool is_control(char32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0);
}

/// Without a shape of its own: spaces of no width, marks of direction, separators of lines.
bool is_invisible(char32_t code) {
    return code == 0xad || (code >= 0x200b && code <= 0x200f) || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2060 && code <= 0x206f) || code == 0xfeff;
}

void append_utf8(std::string& text, char32_t code) {
    const auto rest = [&](int shift) { text += static_cast<char>(0x80U | ((code >> shift) & 0x3fU)); };
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xc0U | code >> 6);
        rest(0);
    } else if (code < 0x10000) {
        text += static_cast<char>(0xe0U | code >> 12);
        rest(6);
        rest(0);
    } else {
        text += static_cast<char>(0xf0U | code >> 18);
        rest(12);
        rest(6);
        rest(0);
    }
}

char32_t lower_case(char32_t code) {
    if (code < 0x80) return code >= 'A' && code <= 'Z' ? code + ('a' - 'A') : code;
    // The program's own locale knows ASCII only. Where there is no C.UTF-8, other letters keep their case.
    static const locale_t unicode = ::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
    if (unicode == nullptr) return code;
    return static_cast<char32_t>(::towlower_l(static_cast<wint_t>(code), unicode));
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Takes the digits that \p text begins with, without zeros in front.
std::string_view take_number(std::string_view& text) {
    const auto digits = static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
    std::string_view number = text.substr(0, digits);
    text.remove_prefix(digits);
    number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
    return number;
}

}  // namespace

std::string shown_name(std::string_view name) {
    std::string shown;
    shown.reserve(name.size());
    while (!name.empty()) {
        const auto character = first_character(name);
        const std::size_t size = character ? character->size : 1;
        if (!character || is_control(character->code)) {
            for (const char c : name.substr(0, size))
                shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        } else if (is_invisible(character->code)) {
            shown += fmt::format("\\u{{{:x}}}", static_cast<std::uint32_t>(character->code));
        } else {
            shown += name.substr(0, size);
        }
        name.remove_prefix(size);
    }
    return shown;
}

bool is_editable(std::string_view name) {
    while (!name.empty()) {
        const auto character = first_character(name);
        // Dear ImGui holds 16 bits a character.
        if (!character || is_control(character->code) || character->code > 0xffff) return false;
        name.remove_prefix(character->size);
    }
    return true;
}

std::string folded(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const auto character = first_character(text);
        if (character) {
            append_utf8(result, lower_case(character->code));
        } else {
            result += text.front();
        }
        text.remove_prefix(character ? character->size : 1);
    }
    return result;
}

bool is_naturally_before(std::string_view a, std::string_view b) {
    const std::string_view whole_a = a;
    const std::string_view whole_b = b;
    while (!a.empty() && !b.empty()) {
        if (is_digit(a.front()) && is_digit(b.front())) {
            const std::string_view number_a = take_number(a);
            const std::string_view number_b = take_number(b);
            if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
            if (number_a != number_b) return number_a < number_b;
        } else {
            // Bytes of UTF-8 compare as their code points do, being unsigned.
            if (a.front() != b.front())
                return static_cast<unsigned char>(a.front()) < static_cast<unsigned char>(b.front());
            a.remove_prefix(1);
            b.remove_prefix(1);
        }
    }
    if (a.empty() != b.empty()) return a.empty();
    if (whole_a.size() != whole_b.size()) return whole_a.size() < whole_b.size();
    return whole_a < whole_b;
}

}  // namespace interleaf
