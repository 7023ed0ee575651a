#include "io/words.h"

#include <algorithm>
#include <cmath>

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

std::optional<float> parse_float(std::string_view word) {
    word = without_plus(word);
    float number = 0;
    std::errc error = parse_word(word, number);
    if (error == std::errc::result_out_of_range) {
        // Too small for a float is as good as 0; only too large is wrong.
        double wide = 0;
        error = parse_word(word, wide);
        if (std::abs(wide) < 1)
            number = static_cast<float>(wide);
        else
            error = std::errc::result_out_of_range;
    }
    if (error != std::errc() || !std::isfinite(number)) return std::nullopt;
    return number;
}

std::optional<double> parse_double(std::string_view word) {
    word = without_plus(word);
    double number = 0;
    std::errc error = parse_word(word, number);
    if (error == std::errc::result_out_of_range) {
        // libstdc++ leaves the number alone then; a negative exponent tells that it is too small.
        const std::size_t exponent = word.find_first_of("eE");
        if (exponent != std::string_view::npos && word.substr(exponent + 1).starts_with('-'))
            error = std::errc();
    }
    if (error != std::errc() || !std::isfinite(number)) return std::nullopt;
    return number;
}

}  // namespace interleaf
