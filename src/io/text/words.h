// Lines of text files, the words in them, and the numbers that words stand for.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace interleaf {

/// Removes the next line from the front of \p text.
/// \return the line, without its end
/// \pre    \p text is not empty
std::string_view take_line(std::string_view& text);

/// Removes the next word from the front of \p line. Blanks, tabs and carriage returns separate words.
/// \return the word; empty at the end of the line
std::string_view take_word(std::string_view& line);

/// Whether \p word is \p expected in any case.
/// \pre \p expected is in lower case
bool is_word(std::string_view word, std::string_view expected);

/// The words of a text, on any lines.
class Words {
  public:
    explicit Words(std::string_view text) : rest_(text) {}

    /// The next word; empty at the end.
    std::string_view next();

    /// The line of the last word, counted from 1.
    std::size_t line() const { return line_; }

    /// The text after the last word.
    std::string_view rest() const { return rest_; }

  private:
    std::string_view rest_;
    std::size_t line_ = 1;
};

/// The number nearest to \p word, which may begin with a plus sign; none unless it is finite. What is too
/// small is 0.
std::optional<double> parse_double(std::string_view word);

/// The float nearest to \p number. It is never inlined, because g++ 12 optimizes a conversion of a vector of
/// doubles to floats and back away when it sees both.
[[gnu::noinline]] double rounded_to_float(double number);

/// Like parse_double(), for a coordinate or a component of a color. The result is in the range of floats, and
/// the float nearest to it is also the float nearest to \p word. A word that programs print for an undefined
/// or infinite number ("nan", "-inf", "1.#QNAN") gives NaN.
std::optional<double> parse_coordinate(std::string_view word);

}  // namespace interleaf
