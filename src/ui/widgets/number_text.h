// Numbers as people read them.
#pragma once

#include <cstddef>
#include <string>

namespace interleaf {

/// \p number with its thousands grouped: "34,612".
std::string grouped(std::size_t number);

/// \p value rounded to a multiple of 10^\p exponent. The result is the double that its digits mean: 1.39,
/// rather than 139 times 0.01, which is 1.3900000000000001.
double rounded_to_power(double value, int exponent);

}  // namespace interleaf
