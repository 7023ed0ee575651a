// The arrows of a vector field in pictures and films that are written to files; they look as in the window
// (ui/widgets/arrow_marks.h).
#pragma once

#include <cstdint>
#include <span>

#include "app/pictures/vector_arrows.h"

namespace interleaf {

/// The side of the cell of an arrow in a picture of this size, in pixels.
float arrow_cell_of(int width, int height);

/// \param rgba  8 bits per channel, sRGB-encoded, top row first; 4 \p width \p height bytes
void draw_arrows(std::span<std::uint8_t> rgba, int width, int height, std::span<const Arrow> arrows);

}  // namespace interleaf
