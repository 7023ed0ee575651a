// The slider of the level of detail.
#pragma once

#include <cstddef>

namespace interleaf {

/// \param detail  0 for the roots to 1 for the whole keys
/// \param leaves  number of leaves of the shown surface
/// \return the detail that the user wants
float detail_panel(float detail, std::size_t leaves);

}  // namespace interleaf
