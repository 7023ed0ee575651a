// The legend, the text and the arrows over pictures in memory.
#include "app/pictures/picture_legend.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <doctest/doctest.h>

#include "app/pictures/picture_arrows.h"
#include "app/pictures/pixel_canvas.h"
#include "app/sample_family.h"

using namespace interleaf;

namespace {

/// A picture of one color.
struct FlatPicture {
    int width;
    int height;
    std::vector<std::uint8_t> rgba;

    FlatPicture(int wide, int high, std::uint8_t alpha = 255)
        : width(wide), height(high), rgba(std::size_t{4} * unsigned(wide) * unsigned(high), 40) {
        for (std::size_t n = 3; n < rgba.size(); n += 4) rgba[n] = alpha;
    }
    const std::uint8_t* at(int x, int y) const {
        return rgba.data() + 4 * (std::size_t(y) * unsigned(width) + unsigned(x));
    }
    bool is_changed(int x, int y) const { return at(x, y)[0] != 40 || at(x, y)[1] != 40; }

    /// The number of changed pixels with x in [from, to).
    int changed(int from, int to) const {
        int count = 0;
        for (int y = 0; y < height; ++y)
            for (int x = from; x < to; ++x) count += is_changed(x, y) ? 1 : 0;
        return count;
    }
};

constexpr glm::vec4 white(1, 1, 1, 1);

}  // namespace

TEST_CASE("the legend has the title and the scale of the shown scalar, and colors have none") {
    const std::vector<FamilyField> fields = {
        {.label = {"T", FieldKind::scalar}, .min = -1, .max = 1, .offset = 300, .unit = "K"},
        {.label = {"c", FieldKind::color}}};
    Display display;
    display.field = "T";
    CHECK_FALSE(has_picture_legend(display, fields));
    display.coloring = Coloring::field;
    REQUIRE(has_picture_legend(display, fields));
    CHECK(picture_legend(display, fields, {}, {}, {}).title == "T (K)");
    display.field = "c";
    CHECK_FALSE(has_picture_legend(display, fields));
}

TEST_CASE("every coloring but plain and checker has a legend that says what its colors mean") {
    const Family family = sample_family();
    const UnionMesh mesh = unite(family, {{0, 0.5}, {2, 0.5}});
    const std::vector<std::string> names = {"first", "second", "third"};
    const std::vector<std::size_t> keys = {0, 2};
    Display display;
    for (const Coloring coloring : colorings(false)) {
        display.coloring = coloring;
        const bool is_without = coloring == Coloring::plain || coloring == Coloring::checker;
        CHECK(has_picture_legend(display, {}) != is_without);
        if (is_without) continue;
        const PictureLegend legend = picture_legend(display, {}, names, keys, mesh);
        CHECK_FALSE(legend.title.empty());
        FlatPicture picture(640, 360);
        draw_legend(picture.rgba, picture.width, picture.height, legend);
        CHECK(picture.changed(0, 320) == 0);
        CHECK(picture.changed(320, 640) > 500);
    }
    display.coloring = Coloring::origin;
    const PictureLegend origins = picture_legend(display, {}, names, keys, mesh);
    const auto& entries = std::get<std::vector<LegendEntry>>(origins.colors);
    REQUIRE(entries.size() == origins_of(mesh).size());
    CHECK(entries.back() == LegendEntry{origin_color(3, keys), "first + third"});
    display.coloring = Coloring::level;
    CHECK(std::get<LevelRange>(picture_legend(display, {}, names, keys, mesh).colors) == level_range(mesh));
    display.coloring = Coloring::common;
    const PictureLegend common = picture_legend(display, {}, names, keys, mesh);
    CHECK(std::get<std::vector<LegendEntry>>(common.colors).front().text == "in all active keys");
}

TEST_CASE("a list keeps its width, and shows as many of its entries as there is room for") {
    const auto list_of = [](std::size_t count) {
        PictureLegend legend{.title = "Bisected this far in", .colors = std::vector<LegendEntry>()};
        auto& entries = std::get<std::vector<LegendEntry>>(legend.colors);
        for (std::size_t n = 0; n < count; ++n) entries.push_back({{1, 0, 0}, std::string(n + 1, 'w')});
        return legend;
    };
    const auto reds = [](const FlatPicture& picture) {
        int count = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const std::uint8_t* const pixel = picture.at(x, y);
                count += pixel[0] == 255 && pixel[1] == 0 ? 1 : 0;
            }
        return count;
    };
    std::array<int, 3> red{};
    for (std::size_t n = 0; n < 3; ++n) {
        const PictureLegend legend = list_of(std::array<std::size_t, 3>{1, 4, 500}[n]);
        CHECK(legend_part(640, 360, legend) == legend_part(640, 360, list_of(2)));
        FlatPicture picture(640, 360);
        draw_legend(picture.rgba, picture.width, picture.height, legend);
        red[n] = reds(picture);
    }
    CHECK(red[0] > 20);
    CHECK(red[1] == 4 * red[0]);
    CHECK(red[2] > 5 * red[0]);
    CHECK(red[2] < 20 * red[0]);
}

TEST_CASE("the legend of levels keeps its width when the levels get a second digit") {
    const PictureLegend few{.title = "Level", .colors = LevelRange{.min = 0, .max = 9}};
    const PictureLegend many{.title = "Level", .colors = LevelRange{.min = 0, .max = 12}};
    CHECK(legend_part(640, 360, few) == legend_part(640, 360, many));
}

TEST_CASE("a light picture has a light legend") {
    PictureLegend legend{.title = "Level", .colors = LevelRange{.min = 0, .max = 30}};
    const auto mean = [&] {
        FlatPicture picture(640, 360);
        draw_legend(picture.rgba, picture.width, picture.height, legend);
        const int x = 640 - static_cast<int>(640 * legend_part(640, 360, legend));
        return int(picture.at(x + 4, 180)[0]);
    };
    CHECK(mean() < 40);
    legend.is_light = true;
    CHECK(mean() > 150);
}

TEST_CASE("the legend shows all colors of its scale, at the right side of the picture alone") {
    const ColorScale scale{.map = ColorMap::viridis, .range = {0, 1}};
    const PictureLegend legend{.title = "speed (m/s)", .colors = scale};
    FlatPicture picture(640, 360);
    draw_legend(picture.rgba, picture.width, picture.height, legend);
    CHECK(picture.changed(0, 480) == 0);
    CHECK(picture.changed(480, 640) > 2000);
    for (const float value : {0.02F, 0.5F, 0.98F}) {
        const glm::vec3 color = 255.0F * scale.color(value);
        bool is_there = false;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 480; x < picture.width; ++x) {
                const std::uint8_t* const pixel = picture.at(x, y);
                is_there = is_there || (std::abs(float(pixel[0]) - color.r) < 4 &&
                                        std::abs(float(pixel[1]) - color.g) < 4 &&
                                        std::abs(float(pixel[2]) - color.b) < 4);
            }
        CHECK(is_there);
    }
}

TEST_CASE("legends of any picture stay inside it, and a picture that is too small gets none") {
    const PictureLegend legend{.title = std::string(300, 'w'),
                               .colors = ColorScale{.range = {-1e30F, 1e30F}, .offset = 1e38}};
    for (const auto& [width, height] :
         {std::pair{1, 1}, {40, 300}, {300, 40}, {200, 150}, {2000, 120}, {120, 2000}}) {
        FlatPicture picture(width, height);
        draw_legend(picture.rgba, width, height, legend);
        CHECK(picture.changed(0, width / 2 - 2) == 0);
        if (std::min(width, height) <= 40) CHECK(picture.changed(0, width) == 0);
    }
}

TEST_CASE("text is as wide as it says, and bytes that are no UTF-8 do no harm") {
    const float width = PixelCanvas::text_width(20, "gradient 0.5");
    CHECK(width > 60);
    CHECK(width < 160);
    CHECK(PixelCanvas::text_width(40, "gradient 0.5") == doctest::Approx(2 * width));
    FlatPicture picture(200, 40);
    PixelCanvas canvas(picture.rgba, picture.width, picture.height);
    canvas.text({10, 5}, 20, "gradient 0.5", white);
    CHECK(picture.changed(10, 12 + int(width)) > 100);
    CHECK(picture.changed(14 + int(width), 200) == 0);
    canvas.text({0, 0}, 20, "\xff\xc3", white);
    canvas.text({-1000, 1e6F}, 20, "outside", white);
}

TEST_CASE("shapes cover their places, also where the picture is transparent") {
    FlatPicture picture(40, 40, 0);
    PixelCanvas canvas(picture.rgba, 40, 40);
    canvas.fill({10, 10}, {20, 20}, 0, {1, 0, 0, 0.5F});
    CHECK(picture.at(15, 15)[0] == 255);
    CHECK(picture.at(15, 15)[3] == 128);
    CHECK(picture.at(25, 15)[3] == 0);
    canvas.line({0, 30}, {40, 30}, 2, white);
    CHECK(picture.at(20, 29)[3] == 255);
    CHECK(picture.at(20, 33)[3] == 0);
    canvas.triangle({2, 2}, {2, 8}, {8, 2}, white);
    CHECK(picture.at(3, 3)[3] == 255);
    CHECK(picture.at(7, 7)[3] == 0);
}

TEST_CASE("an arrow goes from its begin to its end, in either direction") {
    for (const bool turned : {false, true}) {
        FlatPicture picture(100, 40);
        const glm::vec2 left(20, 20);
        const glm::vec2 right(80, 20);
        const std::vector<Arrow> arrows = {turned ? Arrow{right, left} : Arrow{left, right}};
        draw_arrows(picture.rgba, 100, 40, arrows);
        CHECK(picture.is_changed(50, 20));
        CHECK(picture.changed(0, 17) == 0);
        CHECK(picture.changed(84, 100) == 0);
        const int head = picture.changed(70, 84);
        const int tail = picture.changed(17, 31);
        CHECK((turned ? tail > head : head > tail));
    }
}
