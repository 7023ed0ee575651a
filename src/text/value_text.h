// Values of quantities, for legends and reports.
#pragma once

#include <string>
#include <string_view>

namespace interleaf {

/// \p value with four digits, or with as many as tell apart values that differ by a thousandth of \p range:
/// "300.05" for a range of 0.2.
/// \param range  length of the range that the value belongs to; 0 if unknown
std::string value_text(double value, double range);

/// \p text with \p unit behind it: "3.5 m/s"; \p text alone if the unit is empty.
std::string with_unit(std::string text, std::string_view unit);

/// The title of a quantity: "speed (m/s)", or \p name alone if the unit is empty.
std::string title_with_unit(std::string_view name, std::string_view unit);

}  // namespace interleaf
