#include "io/text/words.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text/parsed_number.h"

namespace interleaf {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view without_plus(std::string_view word) {
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    return word;
}

}  // namespace

std::string_view take_line(std::string_view& text) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    return line;
}

std::string_view take_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

bool is_word(std::string_view word, std::string_view expected) {
    return std::ranges::equal(word, expected, [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
    });
}

std::string_view Words::next() {
    constexpr std::string_view spaces = " \t\r\n\v\f";
    const std::size_t begin = std::min(rest_.find_first_not_of(spaces), rest_.size());
    line_ += static_cast<std::size_t>(std::ranges::count(rest_.substr(0, begin), '\n'));
    rest_.remove_prefix(begin);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(spaces));
    rest_.remove_prefix(word.size());
    return word;
}

std::optional<double> parse_double(std::string_view word) {
    word = without_plus(word);
    double number = 0;
    std::errc error = parse_all(word, number);
    if (error == std::errc::result_out_of_range) {
        // libstdc++ leaves the number unchanged then. A negative exponent shows that it is too small.
        const std::size_t exponent = word.find_first_of("eE");
        if (exponent != std::string_view::npos && word.substr(exponent + 1).starts_with('-'))
            error = std::errc();
    }
    if (error != std::errc() || !std::isfinite(number)) return std::nullopt;
    return number;
}

double rounded_to_float(double number) {
    return static_cast<float>(number);
}

std::optional<double> parse_coordinate(std::string_view word) {
    if (std::optional<double> number = parse_double(word)) {
        // A number that is nearer to the largest float than to the next step above it becomes that float.
        constexpr double largest = std::numeric_limits<float>::max();
        constexpr double beyond = largest + 0x1p103;
        if (std::abs(*number) >= beyond) return std::nullopt;
        if (std::abs(*number) > largest) return std::copysign(largest, *number);
        // Halfway between two floats, the rounding to double may hide on which side the word is.
        const auto nearest = static_cast<float>(*number);
        const double offset = *number - double{nearest};
        const float other = std::nextafter(nearest, offset < 0 ? -HUGE_VALF : HUGE_VALF);
        if (offset != 0 && std::abs(double{other} - *number) == std::abs(offset)) {
            float exact = 0;
            if (parse_all(without_plus(word), exact) == std::errc() && exact != nearest)
                number = std::nextafter(*number, double{exact});
        }
        return number;
    }
    const std::string_view unsigned_word =
        word.substr(word.starts_with('-') || word.starts_with('+') ? 1 : 0);
    double number = 0;
    const bool is_special = unsigned_word.starts_with("1.#") ||
                            (parse_all(unsigned_word, number) == std::errc() && !std::isfinite(number));
    if (!is_special) return std::nullopt;
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace interleaf
