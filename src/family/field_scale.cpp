#include "family/field_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "text/characters.h"
#include "text/value_text.h"

namespace interleaf {

bool is_unit(std::string_view text) {
    return text.size() <= max_unit && is_printable(text);
}

FieldScale scale_of(std::span<const FieldScale> scales, std::string_view field) {
    const auto found = std::ranges::find(scales, field, &FieldScale::field);
    return found == scales.end() ? FieldScale{.field = std::string(field)} : *found;
}

void set_scale(std::vector<FieldScale>& scales, FieldScale scale) {
    const bool says_nothing = scale.offset == 0 && scale.unit.empty();
    const auto found = std::ranges::find(scales, scale.field, &FieldScale::field);
    if (found == scales.end()) {
        if (!says_nothing) scales.push_back(std::move(scale));
    } else if (says_nothing) {
        scales.erase(found);
    } else {
        *found = std::move(scale);
    }
}

double offset_for(double low, double high) {
    // A float rounds by up to 2^-24 of its value, which is a millionth of the range where values are 16 ranges large.
    constexpr double max_size = 8;
    const double range = high - low;
    const double size = std::max(std::abs(low), std::abs(high));
    constexpr double noise = 1e-12;
    if (!std::isfinite(range) || size <= max_size * range || range <= noise * size) return 0;
    const double middle = low / 2 + high / 2;
    const double exponent = std::floor(std::log10(range));
    const double power = std::pow(10, std::abs(exponent));
    const double offset =
        exponent < 0 ? std::round(middle * power) / power : std::round(middle / power) * power;
    return std::isfinite(offset) ? offset : 0;
}

std::string offset_sentence(const FieldScale& scale) {
    return fmt::format("The values of {} are the differences from {}.", scale.field,
                       with_unit(fmt::format("{:.15g}", scale.offset), scale.unit));
}

}  // namespace interleaf
