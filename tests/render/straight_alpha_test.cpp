// Tests of straight alpha.
#include "render/straight_alpha.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <doctest/doctest.h>
#include <glm/vec3.hpp>

#include "hierarchy/color.h"

using namespace interleaf;

TEST_CASE("a color that covers part of a pixel comes back whole") {
    for (int alpha = 16; alpha < 256; alpha += 13) {
        CAPTURE(alpha);
        const glm::vec3 color(0.9F, 0.4F, 0.2F);
        const glm::vec3 drawn = encoded(linear_light(color) * (static_cast<float>(alpha) / 255));
        std::array<std::uint8_t, 4> pixel{};
        for (int c = 0; c < 3; ++c)
            pixel[static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(std::lround(255 * drawn[c]));
        pixel[3] = static_cast<std::uint8_t>(alpha);
        make_alpha_straight(pixel);
        for (int c = 0; c < 3; ++c)
            CHECK(std::abs(static_cast<float>(pixel[static_cast<std::size_t>(c)]) - 255 * color[c]) < 6);
        CHECK(pixel[3] == alpha);
    }
}

TEST_CASE("what is opaque or empty stays as it is") {
    std::array<std::uint8_t, 8> pixels{10, 20, 30, 255, 0, 0, 0, 0};
    const auto before = pixels;
    make_alpha_straight(pixels);
    CHECK(pixels == before);
}
