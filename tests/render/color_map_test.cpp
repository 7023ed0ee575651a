// Tests of color maps and scales without OpenGL.
#include "render/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "hierarchy/color.h"

using namespace interleaf;

namespace {

// CIE 1976 L*a*b* of sRGB (D65), literally.
const glm::dmat3 xyz_of_rgb = glm::transpose(glm::dmat3(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522,
                                                        0.0721750, 0.0193339, 0.1191920, 0.9503041));

glm::dvec3 lab_of(glm::vec3 color) {
    const glm::dvec3 white = xyz_of_rgb * glm::dvec3(1);
    const glm::dvec3 xyz = xyz_of_rgb * glm::dvec3(linear_light(color)) / white;
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    return {116 * f(xyz.y) - 16, 500 * (f(xyz.x) - f(xyz.y)), 200 * (f(xyz.y) - f(xyz.z))};
}

glm::vec3 color_of_lab(const glm::dvec3& lab) {
    const double fy = (lab.x + 16) / 116;
    const auto inverse = [](double f) { return f * f * f > 0.008856 ? f * f * f : (f - 16.0 / 116) / 7.787; };
    const glm::dvec3 xyz(inverse(fy + lab.y / 500), inverse(fy), inverse(fy - lab.z / 200));
    const glm::dvec3 light = glm::inverse(xyz_of_rgb) * (xyz * (xyz_of_rgb * glm::dvec3(1)));
    return encoded(glm::clamp(glm::vec3(light), 0.0F, 1.0F));
}

// Moreland's Msh: the polar form of Lab.
glm::dvec3 msh_of(glm::vec3 color) {
    const glm::dvec3 lab = lab_of(color);
    const double m = glm::length(lab);
    return {m, std::acos(lab.x / m), std::atan2(lab.z, lab.y)};
}

glm::vec3 color_of_msh(const glm::dvec3& msh) {
    return color_of_lab(msh.x * glm::dvec3(std::cos(msh.y), std::sin(msh.y) * std::cos(msh.z),
                                           std::sin(msh.y) * std::sin(msh.z)));
}

/// The hue of the white in the middle, as seen from \p color (Moreland 2009, section 5).
double adjusted_hue(const glm::dvec3& color, double white) {
    if (color.x >= white) return color.z;
    const double spin =
        color.y * std::sqrt(white * white - color.x * color.x) / (color.x * std::sin(color.y));
    return color.z > -std::numbers::pi / 3 ? color.z + spin : color.z - spin;
}

/// The diverging map between two colors by its formula.
glm::vec3 literal_coolwarm(double place) {
    const glm::dvec3 cool = msh_of(glm::vec3(59, 76, 192) / 255.0F);
    const glm::dvec3 warm = msh_of(glm::vec3(180, 4, 38) / 255.0F);
    const double white = std::max({cool.x, warm.x, 88.0});
    const glm::dvec3& end = place < 0.5 ? cool : warm;
    const glm::dvec3 middle(white, 0, adjusted_hue(end, white));
    return color_of_msh(glm::mix(middle, end, std::abs(2 * place - 1)));
}

}  // namespace

TEST_CASE("coolwarm agrees with Moreland's formula to 2.3 of 255") {
    float worst = 0;
    for (int n = 0; n <= 1000; ++n) {
        const glm::vec3 off = glm::abs(color_at(ColorMap::coolwarm, static_cast<float>(n) / 1000) -
                                       literal_coolwarm(n / 1000.0));
        worst = std::max({worst, off.r, off.g, off.b});
    }
    CHECK(255 * worst < 2.3F);
    CHECK(glm::distance(literal_coolwarm(0.5), glm::vec3(221) / 255.0F) < 0.005F);
}

TEST_CASE("the ends of viridis and magma are those of matplotlib") {
    const auto ends = [](ColorMap map, glm::vec3 first, glm::vec3 last) {
        CHECK(glm::distance(255.0F * color_at(map, 0), first) < 0.01F);
        CHECK(glm::distance(255.0F * color_at(map, 1), last) < 0.01F);
    };
    ends(ColorMap::viridis, {68, 1, 84}, {253, 231, 37});
    ends(ColorMap::magma, {0, 0, 4}, {252, 253, 191});
    // The middle of the 256 published colors: #21918c and #b73779, halfway between numbers 127 and 128.
    CHECK(glm::distance(255.0F * color_at(ColorMap::viridis, 0.5F), glm::vec3(33, 145, 140)) < 1.5F);
    CHECK(glm::distance(255.0F * color_at(ColorMap::magma, 0.5F), glm::vec3(183, 55, 121)) < 1.5F);
}

TEST_CASE("lightness rises evenly; in the diverging map it rises from both ends to the middle") {
    for (const ColorMap map : color_maps()) {
        CAPTURE(name_of(map));
        const auto lightness = [&](double place) {
            return lab_of(color_at(map, static_cast<float>(place))).x;
        };
        const double lightest = is_diverging(map) ? 0.5 : 1;
        for (const double end : {0.0, is_diverging(map) ? 1.0 : 0.0}) {
            CHECK(lightness(lightest) - lightness(end) > 40);
            for (int n = 0; n < 20; ++n) {
                const double here = lightness(std::lerp(end, lightest, n / 20.0));
                CHECK(lightness(std::lerp(end, lightest, (n + 1) / 20.0)) > here);
                const double even = std::lerp(lightness(end), lightness(lightest), n / 20.0);
                // They are even in other measures, CAM02-UCS and Msh, so not quite in this one.
                CHECK(std::abs(here - even) < (is_diverging(map) ? 9.5 : 6));
            }
        }
    }
}

TEST_CASE("maps are found by name, and have colors beyond their ends") {
    for (const ColorMap map : color_maps()) {
        CHECK(color_map_named(name_of(map)) == map);
        CHECK(color_at(map, -1) == color_at(map, 0));
        CHECK(color_at(map, 2) == color_at(map, 1));
    }
    CHECK_FALSE(color_map_named("jet"));
}

TEST_CASE(
    "a sequential scale runs from end to end, a diverging one has its middle at 0 if the range contains 0") {
    const ColorScale sequential{ColorMap::viridis, {-1, 3}};
    CHECK(sequential.color(-1) == color_at(ColorMap::viridis, 0));
    CHECK(sequential.color(3) == color_at(ColorMap::viridis, 1));
    CHECK(sequential.color(0) == color_at(ColorMap::viridis, 0.25F));
    CHECK(sequential.color(9) == sequential.color(3));

    const ColorScale diverging{ColorMap::coolwarm, {-1, 3}};
    CHECK(diverging.color(0) == color_at(ColorMap::coolwarm, 0.5F));
    CHECK(diverging.color(3) == color_at(ColorMap::coolwarm, 1));
    CHECK(glm::distance(diverging.color(-1), color_at(ColorMap::coolwarm, 1.0F / 3)) < 1e-5F);
    CHECK(diverging.color(-3) == diverging.color(-1));
    const ColorScale positive{ColorMap::coolwarm, {1, 3}};
    CHECK(positive.color(1) == color_at(ColorMap::coolwarm, 0));
    CHECK(positive.color(2) == color_at(ColorMap::coolwarm, 0.5F));
}

TEST_CASE("equal factors are equal steps of a logarithmic scale, if its range is above 0") {
    const ColorScale scale{ColorMap::viridis, {0.01F, 100}, true};
    CHECK(scale.place(1) == doctest::Approx(0.5));
    CHECK(scale.place(0.1F) == doctest::Approx(0.25));
    CHECK(scale.place(-1) == 0);
    CHECK(scale.place(1e9F) == doctest::Approx(1));
    const ColorScale linear{ColorMap::viridis, {0, 100}, true};
    CHECK_FALSE(linear.uses_logarithm());
    CHECK(linear.place(25) == 0.25F);
}

TEST_CASE("scales of any range have colors") {
    constexpr float most = std::numeric_limits<float>::max();
    for (const ColorMap map : color_maps())
        for (const ValueRange range :
             {ValueRange{2, 2}, {-most, most}, {0, most}, {0, 1e-45F}, {1e6F, 1e6F + 1}})
            for (const float value : {range.min, range.max, 0.0F, most, -most}) {
                const glm::vec3 color = ColorScale{map, range}.color(value);
                for (int c = 0; c < 3; ++c) CHECK((color[c] >= 0 && color[c] <= 1));
            }
    CHECK(ColorScale{ColorMap::viridis, {2, 2}}.color(2) == color_at(ColorMap::viridis, 0.5F));
    CHECK(ColorScale{ColorMap::viridis, {1e6F, 1e6F + 1}}.color(1e6F + 1) == color_at(ColorMap::viridis, 1));
}
