#include "io/film/png_bytes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <stb_image.h>

namespace interleaf {

TEST_CASE("a PNG decodes to the same pixels, top row first") {
    constexpr unsigned seed = 1;
    CAPTURE(seed);
    std::mt19937 random(seed);
    constexpr int width = 37;
    constexpr int height = 11;
    std::vector<std::uint8_t> pixels(std::size_t{4} * width * height);
    for (std::uint8_t& value : pixels) value = static_cast<std::uint8_t>(random());
    const std::string png = png_bytes(pixels, width, height);
    CHECK(png.starts_with("\x89PNG\r\n\x1a\n"));

    int read_width = 0;
    int read_height = 0;
    int channels = 0;
    stbi_uc* read =
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()), static_cast<int>(png.size()),
                              &read_width, &read_height, &channels, 0);
    REQUIRE(read != nullptr);
    CHECK(read_width == width);
    CHECK(read_height == height);
    REQUIRE(channels == 4);
    CHECK(std::equal(pixels.begin(), pixels.end(), read));
    stbi_image_free(read);
}

}  // namespace interleaf
