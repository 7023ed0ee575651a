#include "text/value_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace interleaf {

std::string value_text(double value, double range) {
    constexpr int usual_digits = 4;
    constexpr int max_digits = 15;
    const double size = std::abs(value);
    int digits = usual_digits;
    if (range > 0 && size > range && std::isfinite(size))
        digits += static_cast<int>(std::floor(std::log10(size)) - std::floor(std::log10(range)));
    return fmt::format("{:.{}g}", value, std::min(digits, max_digits));
}

std::string with_unit(std::string text, std::string_view unit) {
    return unit.empty() ? std::move(text) : fmt::format("{} {}", text, unit);
}

std::string title_with_unit(std::string_view name, std::string_view unit) {
    return unit.empty() ? std::string(name) : fmt::format("{} ({})", name, unit);
}

}  // namespace interleaf
