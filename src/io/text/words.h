// Lines of text files, the words in them, and the numbers these stand for.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace interleaf {

/// The next line of \p text, without its end, taken off its front. \pre \p text is not empty
std::string_view take_line(std::string_view& text);

/// The next word of \p line, taken off its front; empty at its end. Blanks, tabs and carriage returns part
/// words.
std::string_view take_word(std::string_view& line);

/// Whether \p word is \p expected, which has small letters, in letters of any case.
bool is_word(std::string_view word, std::string_view expected);

/// The words of a text, whatever lines they are on.
class Words {
  public:
    explicit Words(std::string_view text) : rest_(text) {}

    /// Empty at the end.
    std::string_view next();

    /// Of the last word, counted from 1.
    std::size_t line() const { return line_; }

    /// What follows the last word.
    std::string_view rest() const { return rest_; }

  private:
    std::string_view rest_;
    std::size_t line_ = 1;
};

/// The number nearest to \p word, which may begin with a plus sign; none unless it is finite. What is too
/// small is 0.
std::optional<double> parse_double(std::string_view word);

/// The float nearest to \p number. A function of its own, for g++ 12 takes a vector of doubles that goes to
/// floats and back for unchanged when it optimises both in one place.
double rounded_to_float(double number);

/// The same as parse_double() for a coordinate or a part of a color: within the range of floats, and such
/// that the nearest float is the one nearest to the word, too. A word that stands for no number, or for an
/// infinite one, as programs print them ("nan", "-inf", "1.#QNAN"), is given as NaN.
std::optional<double> parse_coordinate(std::string_view word);

}  // namespace interleaf
