#include "render/read_pixels.h"

#include <algorithm>
#include <cstddef>

#include <glad/gl.h>

namespace interleaf {

std::vector<std::uint8_t> read_pixels(unsigned framebuffer, int width, int height) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    const auto stride = static_cast<std::size_t>(width) * 4;
    std::vector<std::uint8_t> pixels(stride * static_cast<std::size_t>(height));
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);

    // OpenGL's first row is the lowest.
    const auto rows = static_cast<std::ptrdiff_t>(height);
    const auto row = static_cast<std::ptrdiff_t>(stride);
    for (std::ptrdiff_t y = 0; y < rows / 2; ++y)
        std::swap_ranges(pixels.begin() + y * row, pixels.begin() + (y + 1) * row,
                         pixels.begin() + (rows - 1 - y) * row);
    return pixels;
}

}  // namespace interleaf
