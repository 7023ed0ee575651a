#include "io/film/png_bytes.h"

#include <cassert>
#include <cstddef>

#include <stb_image_write.h>

#include "hierarchy/error.h"

namespace interleaf {

std::string png_bytes(std::span<const std::uint8_t> rgba, int width, int height) {
    assert(width > 0 && height > 0);
    assert(rgba.size() == std::size_t{4} * static_cast<unsigned>(width) * static_cast<unsigned>(height));
    std::string bytes;
    const auto append = [](void* target, void* data, int size) {
        static_cast<std::string*>(target)->append(static_cast<const char*>(data),
                                                  static_cast<std::size_t>(size));
    };
    if (stbi_write_png_to_func(append, &bytes, width, height, 4, rgba.data(), 4 * width) == 0)
        throw MachineError("not enough memory to compress the picture");
    return bytes;
}

}  // namespace interleaf
