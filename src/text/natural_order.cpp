#include "text/natural_order.h"

#include <algorithm>

#include "text/characters.h"

namespace interleaf {

namespace {

constexpr std::string_view digits = "0123456789";

/// The run of digits, or the one other byte, that \p text begins with; taken off it.
std::string_view take_part(std::string_view& text) {
    const std::size_t run = std::min(text.find_first_not_of(digits), text.size());
    const std::string_view part = text.substr(0, std::max<std::size_t>(run, 1));
    text.remove_prefix(part.size());
    return part;
}

bool is_number(std::string_view part) {
    return digits.find(part.front()) != std::string_view::npos;
}

std::string_view without_zeros(std::string_view number) {
    return number.substr(std::min(number.find_first_not_of('0'), number.size()));
}

std::strong_ordering compare_parts(std::string_view a, std::string_view b) {
    // Bytes of UTF-8, which compare as unsigned ones, are in the order of their code points.
    if (!is_number(a) || !is_number(b)) return a <=> b;
    a = without_zeros(a);
    b = without_zeros(b);
    return a.size() != b.size() ? a.size() <=> b.size() : a <=> b;
}

std::strong_ordering compare_by_numbers(std::string_view a, std::string_view b) {
    while (!a.empty() && !b.empty())
        if (const auto order = compare_parts(take_part(a), take_part(b)); order != 0) return order;
    return a.size() <=> b.size();
}

}  // namespace

NaturalName::NaturalName(std::string_view name) : text(name), folded(interleaf::folded(name)) {}

std::strong_ordering NaturalName::operator<=>(const NaturalName& other) const {
    if (const auto order = compare_by_numbers(folded, other.folded); order != 0) return order;
    return text <=> other.text;
}

std::string without_numbers(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::string_view part = take_part(text);
        result += is_number(part) ? "0" : part;
    }
    return result;
}

}  // namespace interleaf
