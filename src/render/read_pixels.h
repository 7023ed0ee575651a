// Reading what was drawn into a framebuffer.
#pragma once

#include <cstdint>
#include <vector>

namespace interleaf {

/// 8-bit RGBA of the lower left \p width x \p height pixels of \p framebuffer (0: the back buffer of the
/// window), as they are stored, top row first.
std::vector<std::uint8_t> read_pixels(unsigned framebuffer, int width, int height);

}  // namespace interleaf
