// Buttons side by side of which one is chosen.
#pragma once

#include <cstddef>
#include <span>

namespace interleaf {

/// \param name    unique in its window
/// \param width   of all together
/// \return the one that is chosen now: \p chosen, or what was clicked
std::size_t choice(const char* name, std::span<const char* const> labels, std::size_t chosen, float width);

}  // namespace interleaf
