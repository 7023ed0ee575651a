// Positions of the numbers along a scale.
#pragma once

#include <cstddef>
#include <vector>

namespace interleaf {

/// The multiples of 1, 2 or 5 times a power of ten within [\p min, \p max], ascending: as many as possible,
/// but at most \p max_count. Empty for a range without length.
std::vector<double> scale_ticks(double min, double max, std::size_t max_count);

}  // namespace interleaf
