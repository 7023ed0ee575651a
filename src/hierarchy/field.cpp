#include "hierarchy/field.h"

#include <algorithm>
#include <bit>

namespace interleaf {

namespace {

/// Removes the first character from \p text.
/// \return its code point, or a value that is no code point if \p text does not start with valid UTF-8 (RFC
///     3629)
char32_t take_character(std::string_view& text) {
    constexpr char32_t none = 0xffffffff;
    const auto lead = static_cast<unsigned char>(text.front());
    const auto ones = static_cast<std::size_t>(std::countl_one(lead));
    const std::size_t length = std::max<std::size_t>(ones, 1);
    if (ones == 1 || length > 4 || length > text.size()) return none;
    char32_t number = lead & 0xffU >> ones;
    for (const char c : text.substr(1, length - 1)) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xc0U) != 0x80U) return none;
        number = number << 6 | (byte & 0x3fU);
    }
    text.remove_prefix(length);
    constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = number >= 0xd800 && number < 0xe000;
    return number < least[length] || is_surrogate || number > 0x10ffff ? none : number;
}

bool is_printed(char32_t character) {
    return character >= 0x20 && (character < 0x7f || character >= 0xa0) && character <= 0x10ffff;
}

}  // namespace

bool is_field_name(std::string_view text) {
    if (text.empty() || text.size() > max_field_name) return false;
    while (!text.empty())
        if (!is_printed(take_character(text))) return false;
    return true;
}

std::vector<FieldName> labels(std::span<const Field> fields) {
    std::vector<FieldName> result;
    result.reserve(fields.size());
    for (const Field& field : fields) result.push_back(field.label());
    return result;
}

const Field* find_field(std::span<const Field> fields, const FieldName& label) {
    const auto found =
        std::ranges::find_if(fields, [&](const Field& field) { return field.label() == label; });
    return found == fields.end() ? nullptr : &*found;
}

}  // namespace interleaf
