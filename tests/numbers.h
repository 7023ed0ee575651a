// Numbers that tests give as input.
#pragma once

#include <limits>

namespace interleaf {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace interleaf
