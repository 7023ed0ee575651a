// Writes pictures as PNG (stb).
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace interleaf {

/// The bytes of a PNG file.
/// \param rgba  the picture, 8 bits per channel, top row first; 4 \p width \p height bytes
std::string png_bytes(std::span<const std::uint8_t> rgba, int width, int height);

}  // namespace interleaf
