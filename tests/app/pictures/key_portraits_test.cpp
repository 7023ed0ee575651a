// Tests of the pictures of flat keys: they are seen from the front, and their fields tell them apart.
#include "app/pictures/key_portraits.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glad/gl.h>

#include "render/context.h"

using namespace interleaf;

namespace {

constexpr int side = 64;

using Pixel = std::array<unsigned char, 4>;

Key flat_key(const char* name, std::initializer_list<float> values) {
    Hierarchy key;
    key.roots = RootComplex(3, {{0, 1, 2}});
    key.bits = {0};
    key.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    key.fields = {{"u", FieldKind::scalar, values}};
    return {name, SharedHierarchy(std::move(key))};
}

Family flat_family() {
    Family family;
    family.name = "flat";
    family.keys = {flat_key("first", {0, 0, 0}), flat_key("second", {1, 1, 1})};
    return family;
}

void draw_all(KeyPortraits& portraits) {
    while (portraits.draw_next(0, portraits.portraits().size(), side)) {
    }
}

std::vector<Pixel> pixels_of(const KeyPortrait& portrait) {
    std::vector<Pixel> pixels(std::size_t{side} * side);
    glBindTexture(GL_TEXTURE_2D, portrait.picture.name());
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
}

/// Width and height of the part of a picture that is unlike its left edge.
std::array<int, 2> size_of_shown(const std::vector<Pixel>& pixels) {
    std::array<int, 2> least{side, side};
    std::array<int, 2> most{-1, -1};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Pixel& pixel = pixels[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)];
            const Pixel& edge = pixels[static_cast<std::size_t>(y) * side];
            if (std::abs(int{pixel[0]} - int{edge[0]}) + std::abs(int{pixel[1]} - int{edge[1]}) < 60)
                continue;
            least = {std::min(least[0], x), std::min(least[1], y)};
            most = {std::max(most[0], x), std::max(most[1], y)};
        }
    return {most[0] - least[0] + 1, most[1] - least[1] + 1};
}

}  // namespace

TEST_CASE("flat keys are pictured from the front") {
    const EglContext context;
    KeyPortraits portraits;
    portraits.update(flat_family());
    draw_all(portraits);
    const auto [width, height] = size_of_shown(pixels_of(portraits.portraits().front()));
    CHECK(width > side / 2);
    CHECK(std::abs(width - height) <= 2);
}

TEST_CASE("flat keys are pictured with the shown field, and anew when its colors change") {
    const EglContext context;
    KeyPortraits portraits;
    portraits.update(flat_family());
    draw_all(portraits);
    const std::vector<Pixel> plain = pixels_of(portraits.portraits()[0]);
    CHECK(pixels_of(portraits.portraits()[1]) == plain);

    PortraitLook look{.field = FieldName{"u", FieldKind::scalar}, .scale = {.range = {0, 1}}};
    portraits.set_look(look);
    draw_all(portraits);
    const std::vector<Pixel> least = pixels_of(portraits.portraits()[0]);
    CHECK(least != plain);
    CHECK(pixels_of(portraits.portraits()[1]) != least);

    look.scale.range = {-1, 1};
    portraits.set_look(look);
    draw_all(portraits);
    CHECK(pixels_of(portraits.portraits()[0]) != least);

    look.field = FieldName{"no field", FieldKind::scalar};
    portraits.set_look(look);
    draw_all(portraits);
    CHECK(pixels_of(portraits.portraits()[0]) == plain);
}
