// Numbers in texts: of options, fields, files and of the system.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace interleaf {

/// \p text as a number and nothing else, no blanks and no plus sign. An error where \p text is no number or
/// the number is out of range.
template <typename Number>
std::errc parse_all(std::string_view text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return end == text.data() + text.size() ? error : std::errc::invalid_argument;
}

/// The same; none where there is an error.
template <typename Number>
std::optional<Number> parsed_number(std::string_view text) {
    Number number{};
    if (parse_all(text, number) != std::errc()) return std::nullopt;
    return number;
}

}  // namespace interleaf
