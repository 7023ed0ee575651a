// Positions of the numbers along a scale.
#pragma once

#include <cstddef>
#include <vector>

namespace interleaf {

/// The multiples of 1, 2 or 5 times a power of ten within [\p min, \p max], ascending: as many as possible,
/// but at most \p max_count. Empty for a range without length.
std::vector<double> scale_ticks(double min, double max, std::size_t max_count);

/// The same for a logarithmic scale: powers of ten and, where few of them lie within the range, 2 and 5 times these.
/// \pre \p min is above 0
std::vector<double> logarithmic_ticks(double min, double max, std::size_t max_count);

}  // namespace interleaf
