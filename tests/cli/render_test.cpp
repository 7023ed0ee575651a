// `interleaf render`: pictures without a display.
#include <algorithm>
#include <memory>
#include <span>

#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <stb/stb_image.h>

namespace interleaf {
namespace {

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<unsigned char> rgb;
};

Picture decode(const std::string& png) {
    Picture picture;
    int channels = 0;
    const std::unique_ptr<unsigned char, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(reinterpret_cast<const unsigned char*>(png.data()),
                              static_cast<int>(png.size()), &picture.width, &picture.height, &channels, 3),
        stbi_image_free);
    REQUIRE(pixels != nullptr);
    const std::size_t size =
        3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.rgb.assign(pixels.get(), pixels.get() + size);
    return picture;
}

/// Renders a small picture with the options \p choice.
Picture render(const std::vector<std::string>& choice) {
    std::vector<std::string> line = {"render", "-o", "-", "--format", "png", "--size", "320x180"};
    line.insert(line.end(), choice.begin(), choice.end());
    const Outcome outcome = run_interleaf(line);
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(outcome.errors.empty());
    return decode(outcome.output);
}

/// The fraction of pixels that differ by more than rounding, 0 to 1.
double difference(const Picture& a, const Picture& b) {
    REQUIRE(a.rgb.size() == b.rgb.size());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        const auto differs = [&](std::size_t c) { return std::abs(a.rgb[i + c] - b.rgb[i + c]) > 8; };
        if (differs(0) || differs(1) || differs(2)) ++changed;
    }
    return static_cast<double>(changed) / (static_cast<double>(a.rgb.size()) / 3);
}

TEST_CASE("the picture is a PNG of the given size, by default 1280x720") {
    const ScratchFolder folder;
    REQUIRE(run_interleaf({"render", "--at", "0.3,0.4", "-o", folder / "a.png"}).status == 0);
    const Picture standard = decode(content(folder / "a.png"));
    CHECK(standard.width == 1280);
    CHECK(standard.height == 720);
    REQUIRE(run_interleaf({"render", "--at", "0.3,0.4", "-o", folder / "a.png", "--size", "33x17"}).status ==
            0);
    const Picture small = decode(content(folder / "a.png"));
    CHECK(small.width == 33);
    CHECK(small.height == 17);
}

TEST_CASE("the same command draws the same picture") {
    CHECK(render({"--at", "0.3,0.4"}).rgb == render({"--at", "0.3,0.4"}).rgb);
}

TEST_CASE("every choice changes the picture where it should") {
    const Picture plain = render({"--at", "0.3,0.4"});
    const std::vector<std::vector<std::string>> choices = {
        {"--color", "level"},           {"--color", "origin"},    {"--show", "wireframe"},
        {"--show", "refinement-edges"}, {"--show", "root-edges"}, {"--camera", "120,20"},
        {"--camera", "30,20,2"},        {"--color", "common"},    {"--color", "angle"},
        {"--color", "curvature"},       {"--color", "moved"},     {"--show", "vertices"},
        {"--show", "normals"}};
    std::vector<Picture> pictures = {plain};
    for (std::vector<std::string> choice : choices) {
        choice.insert(choice.end(), {"--at", "0.3,0.4"});
        pictures.push_back(render(choice));
    }
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            CAPTURE(i);
            CAPTURE(j);
            CHECK(difference(pictures[i], pictures[j]) > 0.005);
        }
    }
}

TEST_CASE("a transparent picture has alpha where no surface is, and the surface as it is") {
    const Outcome outcome =
        run_interleaf({"render", "-o", "-", "--format", "png", "--size", "320x180", "--transparent"});
    REQUIRE(outcome.status == 0);
    int width = 0;
    int height = 0;
    int channels = 0;
    const std::unique_ptr<unsigned char, decltype(&stbi_image_free)> rgba(
        stbi_load_from_memory(reinterpret_cast<const unsigned char*>(outcome.output.data()),
                              static_cast<int>(outcome.output.size()), &width, &height, &channels, 4),
        stbi_image_free);
    REQUIRE(rgba != nullptr);
    CHECK(channels == 4);
    const Picture opaque = render({});
    const auto pixel_count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::size_t covered = 0;
    std::size_t empty = 0;
    std::size_t between = 0;
    for (std::size_t i = 0; i < pixel_count; ++i) {
        const unsigned char alpha = rgba.get()[4 * i + 3];
        empty += alpha == 0 ? 1 : 0;
        between += alpha != 0 && alpha != 255 ? 1 : 0;
        if (alpha != 255) continue;
        ++covered;
        for (std::size_t c = 0; c < 3; ++c)
            CHECK(std::abs(rgba.get()[4 * i + c] - opaque.rgb[3 * i + c]) <= 1);
    }
    CHECK(covered > pixel_count / 20);
    CHECK(empty > pixel_count / 2);
    CHECK(between > 20);
    CHECK(between < pixel_count / 20);
}

TEST_CASE("several files of keys are one family") {
    const std::string folder = INTERLEAF_FIVE_KEYS "/";
    CHECK(difference(render({folder + "star.ilh", folder + "sphere.ilh", "--weights", "sphere=1"}),
                     render({folder + "star.ilh", folder + "sphere.ilh", "--weights", "star=1"})) > 0.02);
}

TEST_CASE("the camera rolls, looks at its center from its distance, and leaves out perspective") {
    const auto seen = [](const std::string& camera) {
        return render({"--weights", "star=1", "--camera", camera});
    };
    const Picture plain = seen("30,20");
    CHECK(difference(plain, seen("30,20,roll=360")) < 0.001);
    for (const char* camera :
         {"30,20,roll=40", "30,20,center=0.3:0:0", "30,20,distance=3", "30,20,orthographic"})
        CHECK(difference(plain, seen(camera)) > 0.01);
    // With Z up, the front is what is seen from below with Y up.
    CHECK(difference(seen("0,0,up=Z"), seen("0,-90")) < 0.001);
}

TEST_CASE("a key of few leaves is shaded flat, unless another shading is chosen, and others are smooth") {
    const std::string icosahedron = INTERLEAF_FIVE_KEYS "/icosahedron.ilh";
    const std::string star = INTERLEAF_FIVE_KEYS "/star.ilh";
    CHECK(difference(render({icosahedron}), render({icosahedron, "--shading", "flat"})) == 0);
    CHECK(difference(render({icosahedron}), render({icosahedron, "--shading", "smooth"})) > 0.02);
    CHECK(difference(render({star}), render({star, "--shading", "smooth"})) == 0);
}

TEST_CASE("the scale of measured values takes a range") {
    const auto seen = [](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"--at", "0.5,0.5", "--color", "curvature"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return render(arguments);
    };
    CHECK(difference(seen({}), seen({"--range", "-100,100"})) > 0.02);
}

TEST_CASE("edges are drawn on the surface and leave the background as it is") {
    const Picture plain = render({"--at", "0,0"});
    const Picture edges = render({"--at", "0,0", "--show", "wireframe,refinement-edges,root-edges"});
    const std::size_t row = 3 * static_cast<std::size_t>(plain.width);
    CHECK(std::equal(plain.rgb.begin(), plain.rgb.begin() + static_cast<std::ptrdiff_t>(row),
                     edges.rgb.begin()));
    CHECK(difference(plain, edges) > 0.02);
}

TEST_CASE("a point of the domain gives the same picture as its weights, also at a corner") {
    CHECK(difference(render({"--at", "-1,1"}), render({"--weights", "star=1"})) < 0.001);
    CHECK(difference(render({"--at", "-1,1"}), render({"--at", "1,1"})) > 0.02);
    CHECK(difference(render({"--at", "0.5,0"}), render({"--weights", "sphere=0.5,bone=0.25,cushion=0.25"})) <
          0.001);
}

TEST_CASE("the camera shows all keys: none reaches the border of the picture") {
    for (const std::string key : {"icosahedron", "bone", "cushion", "star", "sphere"}) {
        CAPTURE(key);
        const Picture picture = render({"--weights", key + "=1"});
        const Picture empty = render({"--weights", key + "=0"});
        CHECK(difference(picture, empty) > 0.01);
        const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
        for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
            const bool is_border =
                i < row || i >= picture.rgb.size() - row || i % row < 3 || i % row >= row - 3;
            if (is_border && picture.rgb[i] != empty.rgb[i]) FAIL("drawn on the border");
        }
    }
}

}  // namespace
}  // namespace interleaf
