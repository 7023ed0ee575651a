#include "io/text/plain_text.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "text/characters.h"

namespace interleaf {
namespace {

enum class Encoding { utf8, utf16_little_endian, utf16_big_endian };

constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

unsigned byte_at(std::string_view text, std::size_t place) {
    return static_cast<unsigned char>(text[place]);
}

/// The first characters of a mesh are ASCII, so in UTF-16 every second byte is 0.
Encoding encoding_of(std::string_view text) {
    if (text.size() < 4) return Encoding::utf8;
    if (text.starts_with("\xff\xfe")) return Encoding::utf16_little_endian;
    if (text.starts_with("\xfe\xff")) return Encoding::utf16_big_endian;
    const auto is_ascii = [&](std::size_t place) {
        return byte_at(text, place) >= 0x09 && byte_at(text, place) < 0x7f;
    };
    if (is_ascii(0) && text[1] == 0 && is_ascii(2) && text[3] == 0) return Encoding::utf16_little_endian;
    if (text[0] == 0 && is_ascii(1) && text[2] == 0 && is_ascii(3)) return Encoding::utf16_big_endian;
    return Encoding::utf8;
}

/// Characters beyond the first 65,536 become two characters of three bytes each. Meshes do not need them.
std::string utf8_of(std::string_view text, Encoding encoding) {
    const std::size_t low = encoding == Encoding::utf16_little_endian ? 0 : 1;
    std::string result;
    result.reserve(text.size() / 2 + 16);
    for (std::size_t place = 0; place + 1 < text.size(); place += 2)
        append_character(result, byte_at(text, place + low) | byte_at(text, place + 1 - low) << 8);
    return result;
}

/// Replaces each "\r" by "\n", unless a "\n" follows.
void end_lines(std::string& text) {
    for (std::size_t place = text.find('\r'); place != std::string::npos; place = text.find('\r', place + 1))
        if (place + 1 == text.size() || text[place + 1] != '\n') text[place] = '\n';
}

}  // namespace

std::string plain_text(std::string text, std::vector<std::string>& remarks) {
    if (const Encoding encoding = encoding_of(text); encoding != Encoding::utf8) {
        text = utf8_of(text, encoding);
        remarks.emplace_back("The text was converted from UTF-16.");
    }
    if (text.starts_with(utf8_mark)) text.erase(0, utf8_mark.size());
    end_lines(text);
    return text;
}

bool looks_like_text(std::string_view bytes) {
    constexpr std::size_t most = 1024;
    return std::ranges::none_of(bytes.substr(0, most), [](char c) {
        constexpr std::string_view blanks = "\t\n\v\f\r";
        const auto byte = static_cast<unsigned char>(c);
        // Bytes above ASCII may be letters of an older encoding.
        return byte < 0x80 && is_control(byte) && blanks.find(c) == std::string_view::npos;
    });
}

}  // namespace interleaf
