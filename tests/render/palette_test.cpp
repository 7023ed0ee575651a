// Tests of colors without OpenGL.
#include "render/palette.h"

#include <numeric>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace interleaf;

namespace {

/// CIE luminance of an sRGB-encoded color.
float luminance(glm::vec3 color) {
    return glm::dot(linear_light(color), {0.2126F, 0.7152F, 0.0722F});
}

}  // namespace

TEST_CASE("a deeper level is lighter, from viridis' violet to its yellow") {
    for (const LevelRange& range : {LevelRange{0, 1}, LevelRange{3, 17}, LevelRange{0, 64}}) {
        CHECK(luminance(level_color(range.min, range)) > 0.07F);  // shading stays visible
        CHECK(glm::distance(level_color(range.max, range), glm::vec3(0xfd, 0xe7, 0x25) / 255.0F) < 1e-5F);
        for (unsigned level = range.min; level < range.max; ++level)
            CHECK(luminance(level_color(level, range)) < luminance(level_color(level + 1, range)));
    }
}

TEST_CASE("levels of many leaves differ more in color, and all levels keep their order") {
    const std::vector<std::size_t> leaves{1, 0, 1, 1000, 900, 2};
    const std::vector<float> places = level_places(leaves);
    REQUIRE(places.size() == leaves.size());
    CHECK(places.front() == 0);
    CHECK(places.back() == doctest::Approx(1));
    for (std::size_t level = 1; level < places.size(); ++level) CHECK(places[level] > places[level - 1]);
    CHECK(places[4] - places[3] > 2 * (places[1] - places[0]));
    const std::vector<std::size_t> one_level{7};
    CHECK(level_places(one_level).empty());
    const std::vector<std::size_t> none(3);
    CHECK(level_places(none).size() == 3);
}

TEST_CASE("the level of a mesh with a single level, and levels outside the range, have colors") {
    CHECK(level_color(5, {5, 5}) == level_color(0, {5, 5}));
    CHECK(level_color(9, {2, 6}) == level_color(6, {2, 6}));
}

TEST_CASE("every set of up to four keys has a color of its own") {
    for (std::size_t count = 1; count <= 4; ++count) {
        std::vector<std::size_t> keys(count);
        std::iota(keys.begin(), keys.end(), std::size_t{0});
        for (KeySet a = 1; a < KeySet{1} << count; ++a)
            for (KeySet b = 1; b < a; ++b) {
                CAPTURE(a);
                CAPTURE(b);
                CHECK(glm::distance(origin_color(a, keys), origin_color(b, keys)) > 0.05F);
            }
    }
}

TEST_CASE("a key keeps its color no matter which other keys are active") {
    const std::size_t few[] = {4, 6};
    const std::size_t more[] = {1, 4, 5, 6};
    CHECK(glm::distance(origin_color(key_bit(0), few), key_color(4)) < 1e-3F);
    CHECK(glm::distance(origin_color(key_bit(1), more), key_color(4)) < 1e-3F);
    CHECK(glm::distance(origin_color(key_bit(3), more), key_color(6)) < 1e-3F);
}

TEST_CASE("a leaf belongs to all, some or one of the active keys, and each has its color") {
    CHECK(share_of(0b1, 1) == Share::all);
    CHECK(share_of(0b11, 2) == Share::all);
    CHECK(share_of(0b10, 2) == Share::one);
    CHECK(share_of(0b101, 3) == Share::some);
    CHECK(share_of(0b100, 3) == Share::one);
    CHECK(share_of(~KeySet{0}, 40) == Share::all);  // the keys from the 32nd on share a bit
    CHECK(share_of(~KeySet{0} >> 1, 40) == Share::some);
    CHECK(common_color(Share::all) != common_color(Share::some));
    CHECK(common_color(Share::some) != common_color(Share::one));
    CHECK(common_color(Share::one) != common_color(Share::all));
}
