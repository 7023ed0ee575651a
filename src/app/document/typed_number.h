// Numbers as a person types them, on the command line or into a field.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "hierarchy/triangle.h"

namespace interleaf {

/// The whole of \p text as a number; none where it is none, or is too large.
template <class Number>
std::optional<Number> typed_number(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// The whole of \p text as a number of things: "20000", and "2e4" or "1.5e6" where that is a whole number;
/// none otherwise.
std::optional<Index> typed_count(std::string_view text);

}  // namespace interleaf
