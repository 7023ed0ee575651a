#include "io/vtk/number_array.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/text/json_place.h"

namespace interleaf {
namespace {

/// \p number as a Number, if it is in its range and, for a whole Number, whole.
template <typename Number>
std::optional<Number> converted(double number) {
    if constexpr (std::is_integral_v<Number>) {
        // The largest number of 64 bits rounds up to a double that is out of range.
        constexpr Number half = std::numeric_limits<Number>::max() / 2;
        constexpr double beyond = 2 * (static_cast<double>(half) + 1);
        constexpr auto least = static_cast<double>(std::numeric_limits<Number>::min());
        if (number < least || number >= beyond || std::trunc(number) != number) return std::nullopt;
    } else if (std::abs(number) > double{std::numeric_limits<Number>::max()}) {
        return std::nullopt;
    }
    return static_cast<Number>(number);
}

/// Calls \p action with each number of \p array, as a double, and the number's place in the array.
template <typename Action>
void for_each_number(const NumberArray& array, Action action) {
    with_zero(array.type, [&](auto number) {
        for (std::size_t n = 0; n < array.bytes.size() / sizeof number; ++n) {
            std::memcpy(&number, &array.bytes[n * sizeof number], sizeof number);
            action(static_cast<double>(number), n);
        }
    });
}

/// The number that \p word is; NaN for a word that programs print for an undefined or infinite number.
std::optional<double> number_in(std::string_view word) {
    if (const std::optional<double> number = parse_double(word)) return number;
    const std::optional<double> undefined = parse_coordinate(word);
    return undefined && std::isnan(*undefined) ? undefined : std::nullopt;
}

template <typename Number>
std::vector<Number> whole_numbers(const NumberArray& array, double limit, const ArrayPlace& place) {
    std::vector<Number> numbers;
    numbers.reserve(array.bytes.size() / size_of(array.type));
    for_each_number(array, [&](double number, std::size_t n) {
        if (!(number >= 0 && number < limit) || std::trunc(number) != number)
            place.fail_at(n, fmt::format("{}, expected a whole number in [0, {:.0f})", number, limit));
        numbers.push_back(static_cast<Number>(number));
    });
    return numbers;
}

}  // namespace

std::size_t ArrayPlace::values() const {
    constexpr std::size_t most = std::size_t{1} << 40;
    if (components > 0 && tuples > most / components)
        fail(fmt::format("{} times {} numbers, expected fewer", tuples, components));
    return tuples * components;
}

void ArrayPlace::fail(std::string_view what) const {
    throw InputError(fmt::format("{}: {}: {}", file, name, what));
}

void ArrayPlace::fail_at(std::size_t value, std::string_view what) const {
    fail(fmt::format("{} {} (counted from 0): {}", element, value / std::max<std::size_t>(components, 1),
                     what));
}

void swap_byte_order(NumberArray& array) {
    const auto size = static_cast<std::ptrdiff_t>(size_of(array.type));
    for (auto number = array.bytes.begin(); number != array.bytes.end(); number += size)
        std::reverse(number, number + size);
}

NumberArray read_words(Words& words, DataType type, const ArrayPlace& place) {
    const std::size_t count = place.values();
    if (count > words.rest().size() / 2 + 1)  // each has a digit and a blank
        place.fail(fmt::format("the file ends too early, expected {} numbers", count));
    NumberArray array{type, std::vector<std::byte>(count * size_of(type))};
    with_zero(type, [&](auto zero) {
        for (std::size_t n = 0; n < count; ++n) {
            const std::string_view word = words.next();
            if (word.empty()) place.fail(fmt::format("ends after {} numbers, expected {}", n, count));
            const auto number = number_in(word);
            const auto value = number ? converted<decltype(zero)>(*number) : std::nullopt;
            if (!value)
                place.fail_at(
                    n, fmt::format("{}, expected a number of type {}", in_quotes(word), name_of(type)));
            std::memcpy(&array.bytes[n * sizeof zero], &*value, sizeof zero);
        }
    });
    return array;
}

std::vector<double> doubles_of(const NumberArray& array) {
    std::vector<double> numbers;
    numbers.reserve(array.bytes.size() / size_of(array.type));
    for_each_number(array, [&](double number, std::size_t) { numbers.push_back(number); });
    return numbers;
}

std::vector<double> finite_numbers(const NumberArray& array, const ArrayPlace& place) {
    std::vector<double> numbers;
    numbers.reserve(array.bytes.size() / size_of(array.type));
    for_each_number(array, [&](double number, std::size_t n) {
        if (!std::isfinite(number)) place.fail_at(n, fmt::format("{}, expected a finite number", number));
        numbers.push_back(number);
    });
    return numbers;
}

std::vector<Index> indices_below(const NumberArray& array, std::uint64_t limit, const ArrayPlace& place) {
    return whole_numbers<Index>(array, static_cast<double>(std::min<std::uint64_t>(limit, no_index)), place);
}

std::vector<std::uint8_t> small_numbers(const NumberArray& array, const ArrayPlace& place) {
    return whole_numbers<std::uint8_t>(array, 256, place);
}

}  // namespace interleaf
