// An image as a texture, for the user interface.
#pragma once

#include <cstdint>
#include <span>

#include "render/gl_object.h"

namespace interleaf {

/// A texture of \p width x \p height pixels, without color conversion.
/// \param rgba  8-bit RGBA, top row first
/// \pre  a context is current
GlTexture image_texture(int width, int height, std::span<const std::uint8_t> rgba);

}  // namespace interleaf
