// The form of transparency that PNG files have.
#pragma once

#include <cstdint>
#include <span>

namespace interleaf {

/// Turns a picture that was drawn over nothing into one with straight alpha: each color becomes that of the surface
/// alone, however little of the pixel the surface covers.
/// \param rgba  8-bit RGBA, sRGB-encoded, whose light is multiplied by alpha
void make_alpha_straight(std::span<std::uint8_t> rgba);

}  // namespace interleaf
