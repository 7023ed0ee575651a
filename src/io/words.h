// Lines of text files, the words in them, and the numbers these stand for.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace interleaf {

/// The next line of \p text, without its end, taken off its front. \pre \p text is not empty
std::string_view take_line(std::string_view& text);

/// The next word of \p line, taken off its front; empty at its end. Blanks, tabs and carriage returns part
/// words.
std::string_view take_word(std::string_view& line);

/// The whole of \p word as a number.
template <typename Number>
std::errc parse_word(std::string_view word, Number& number) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return end == word.data() + word.size() ? error : std::errc::invalid_argument;
}

/// The number nearest to \p word, which may begin with a plus sign; none unless it is finite. What is too
/// small is 0.
std::optional<float> parse_float(std::string_view word);
std::optional<double> parse_double(std::string_view word);

}  // namespace interleaf
