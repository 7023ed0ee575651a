// Numbers as people read them.
#pragma once

#include <cstddef>
#include <string>

namespace interleaf {

/// "34,612": thousands grouped.
std::string grouped(std::size_t number);

/// \p value rounded to a multiple of 10^\p exponent: 1.39 as it is typed and not 139 times 0.01, which is
/// 1.3900000000000001.
double rounded_to_power(double value, int exponent);

}  // namespace interleaf
