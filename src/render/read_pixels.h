// Reads pixels from a framebuffer.
#pragma once

#include <cstdint>
#include <vector>

namespace interleaf {

/// The lower left \p width x \p height pixels of \p framebuffer as they are stored: 8-bit RGBA, top row
/// first.
/// \param framebuffer  0 is the back buffer of the window
std::vector<std::uint8_t> read_pixels(unsigned framebuffer, int width, int height);

}  // namespace interleaf
