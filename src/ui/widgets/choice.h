// A row of buttons. One of them is chosen.
#pragma once

#include <cstddef>
#include <span>

namespace interleaf {

/// \param name    unique in its window
/// \param width   total width of the buttons; long labels get the small font
/// \param tips    tooltips, one per button; none if empty
/// \return the chosen button: the clicked one, or \p chosen if none was clicked
std::size_t choice(const char* name, std::span<const char* const> labels, std::size_t chosen, float width,
                   std::span<const char* const> tips = {});

}  // namespace interleaf
