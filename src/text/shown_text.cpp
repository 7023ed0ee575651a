#include "text/shown_text.h"

#include <cstdint>

#include <fmt/core.h>

#include "text/characters.h"

namespace interleaf {

namespace {

/// Without a shape of its own: a space of no width, a mark of direction or a separator of lines.
bool is_invisible(char32_t code) {
    return code == 0xad || (code >= 0x200b && code <= 0x200f) || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2060 && code <= 0x206f) || code == 0xfeff;
}

std::string escaped(std::string_view text, bool escapes_invisible) {
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const auto character = first_character(text);
        const std::size_t size = character ? character->size : 1;
        if (!character || is_control(character->code)) {
            for (const char c : text.substr(0, size))
                shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        } else if (escapes_invisible && is_invisible(character->code)) {
            shown += fmt::format("\\u{{{:x}}}", static_cast<std::uint32_t>(character->code));
        } else {
            shown += text.substr(0, size);
        }
        text.remove_prefix(size);
    }
    return shown;
}

}  // namespace

std::string shown_text(std::string_view text) {
    return escaped(text, false);
}

std::string shown_name(std::string_view name) {
    return escaped(name, true);
}

}  // namespace interleaf
