#include "render/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace interleaf {
namespace {

// Every fifth of matplotlib's 256 colors (_cm_listed.py; public domain, CC0). Linear interpolation between
// them is off by at most 1/255.
constexpr std::array<glm::vec3, 52> viridis = {
    from_hex(0x440154), from_hex(0x46085c), from_hex(0x471063), from_hex(0x481769), from_hex(0x481d6f),
    from_hex(0x482475), from_hex(0x472a7a), from_hex(0x46307e), from_hex(0x453781), from_hex(0x433d84),
    from_hex(0x414287), from_hex(0x3f4889), from_hex(0x3d4e8a), from_hex(0x3a538b), from_hex(0x38598c),
    from_hex(0x355e8d), from_hex(0x33638d), from_hex(0x31688e), from_hex(0x2e6d8e), from_hex(0x2c718e),
    from_hex(0x2a768e), from_hex(0x297b8e), from_hex(0x27808e), from_hex(0x25848e), from_hex(0x23898e),
    from_hex(0x218e8d), from_hex(0x20928c), from_hex(0x1f978b), from_hex(0x1e9c89), from_hex(0x1fa188),
    from_hex(0x21a585), from_hex(0x24aa83), from_hex(0x28ae80), from_hex(0x2eb37c), from_hex(0x35b779),
    from_hex(0x3dbc74), from_hex(0x46c06f), from_hex(0x50c46a), from_hex(0x5ac864), from_hex(0x65cb5e),
    from_hex(0x70cf57), from_hex(0x7cd250), from_hex(0x89d548), from_hex(0x95d840), from_hex(0xa2da37),
    from_hex(0xb0dd2f), from_hex(0xbddf26), from_hex(0xcae11f), from_hex(0xd8e219), from_hex(0xe5e419),
    from_hex(0xf1e51d), from_hex(0xfde725)};

constexpr std::array<glm::vec3, 52> magma = {
    from_hex(0x000004), from_hex(0x02020b), from_hex(0x050416), from_hex(0x090720), from_hex(0x0e0b2b),
    from_hex(0x140e36), from_hex(0x1a1042), from_hex(0x21114e), from_hex(0x29115a), from_hex(0x311165),
    from_hex(0x390f6e), from_hex(0x420f75), from_hex(0x4a1079), from_hex(0x52137c), from_hex(0x5a167e),
    from_hex(0x621980), from_hex(0x6a1c81), from_hex(0x721f81), from_hex(0x792282), from_hex(0x812581),
    from_hex(0x892881), from_hex(0x912b81), from_hex(0x992d80), from_hex(0xa1307e), from_hex(0xaa337d),
    from_hex(0xb2357b), from_hex(0xba3878), from_hex(0xc23b75), from_hex(0xca3e72), from_hex(0xd2426f),
    from_hex(0xd9466b), from_hex(0xe04c67), from_hex(0xe75263), from_hex(0xec5860), from_hex(0xf1605d),
    from_hex(0xf4695c), from_hex(0xf7725c), from_hex(0xf97b5d), from_hex(0xfb8560), from_hex(0xfc8e64),
    from_hex(0xfd9869), from_hex(0xfea16e), from_hex(0xfeaa74), from_hex(0xfeb47b), from_hex(0xfebd82),
    from_hex(0xfec68a), from_hex(0xfecf92), from_hex(0xfed89a), from_hex(0xfde2a3), from_hex(0xfdebac),
    from_hex(0xfcf4b6), from_hex(0xfcfdbf)};

// From Moreland's formula in Msh space, between (59, 76, 192) and (180, 4, 38). Linear interpolation between
// the colors is off by at most 2.3/255, at the red end.
constexpr std::array<glm::vec3, 65> coolwarm = {
    from_hex(0x3b4cc0), from_hex(0x4053c6), from_hex(0x445acc), from_hex(0x4961d2), from_hex(0x4e68d7),
    from_hex(0x536edc), from_hex(0x5875e1), from_hex(0x5d7be6), from_hex(0x6282ea), from_hex(0x6788ee),
    from_hex(0x6c8ef1), from_hex(0x7294f4), from_hex(0x779af7), from_hex(0x7da0f9), from_hex(0x82a5fb),
    from_hex(0x88abfd), from_hex(0x8db0fe), from_hex(0x93b4ff), from_hex(0x98b9ff), from_hex(0x9ebdff),
    from_hex(0xa3c2ff), from_hex(0xa8c6fe), from_hex(0xaec9fd), from_hex(0xb3ccfb), from_hex(0xb8d0f9),
    from_hex(0xbdd2f7), from_hex(0xc2d5f4), from_hex(0xc7d7f1), from_hex(0xccd9ee), from_hex(0xd0daea),
    from_hex(0xd5dbe6), from_hex(0xd9dce1), from_hex(0xdddddd), from_hex(0xe1dbd7), from_hex(0xe5d8d1),
    from_hex(0xe9d6cb), from_hex(0xecd3c6), from_hex(0xeed0bf), from_hex(0xf1ccb9), from_hex(0xf3c8b3),
    from_hex(0xf5c4ad), from_hex(0xf6c0a7), from_hex(0xf7bba0), from_hex(0xf7b69a), from_hex(0xf7b194),
    from_hex(0xf7ac8d), from_hex(0xf7a687), from_hex(0xf6a081), from_hex(0xf49a7b), from_hex(0xf39375),
    from_hex(0xf18d6f), from_hex(0xee8669), from_hex(0xec7f63), from_hex(0xe9785d), from_hex(0xe57057),
    from_hex(0xe26852), from_hex(0xde614c), from_hex(0xd95847), from_hex(0xd55042), from_hex(0xd0473d),
    from_hex(0xcb3e38), from_hex(0xc63333), from_hex(0xc0282f), from_hex(0xba1a2a), from_hex(0xb40426)};

constexpr std::array all_maps = {ColorMap::viridis, ColorMap::magma, ColorMap::coolwarm};
constexpr std::array<std::string_view, all_maps.size()> names = {"viridis", "magma", "coolwarm"};

std::span<const glm::vec3> colors_of(ColorMap map) {
    switch (map) {
        case ColorMap::viridis:
            return viridis;
        case ColorMap::magma:
            return magma;
        case ColorMap::coolwarm:
            return coolwarm;
    }
    return {};
}

}  // namespace

std::span<const ColorMap> color_maps() {
    return all_maps;
}

std::string_view name_of(ColorMap map) {
    return names[static_cast<std::size_t>(map)];
}

std::optional<ColorMap> color_map_named(std::string_view name) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) return std::nullopt;
    return all_maps[static_cast<std::size_t>(found - names.begin())];
}

bool is_diverging(ColorMap map) {
    return map == ColorMap::coolwarm;
}

glm::vec3 color_at(ColorMap map, float place) {
    const std::span<const glm::vec3> colors = colors_of(map);
    const float at = std::clamp(place, 0.0F, 1.0F) * static_cast<float>(colors.size() - 1);
    const auto before = std::min(static_cast<std::size_t>(at), colors.size() - 2);
    return glm::mix(colors[before], colors[before + 1], at - static_cast<float>(before));
}

ColorScale::Placing ColorScale::placing() const {
    if (uses_logarithm()) {
        const float least = std::log(range.min);
        return {least, 1 / std::max(std::log(range.max) - least, std::numeric_limits<float>::min()), 0};
    }
    // In double precision, because the range may be as wide as floats allow.
    const double min = range.min, max = range.max;
    if (!(max > min)) return {range.min, 0, 0.5F};
    const auto to_float = [](double factor) {
        return static_cast<float>(std::min<double>(factor, std::numeric_limits<float>::max()));
    };
    if (!is_diverging(map) || min >= 0 || max <= 0 || offset != 0)
        return {range.min, to_float(1 / (max - min)), 0};
    return {0, to_float(0.5 / std::max(-min, max)), 0.5F};
}

float ColorScale::place(float value) const {
    const auto [base, factor, shift] = placing();
    const float inside = std::clamp(value, range.min, std::max(range.min, range.max));
    return std::clamp(((uses_logarithm() ? std::log(inside) : inside) - base) * factor + shift, 0.0F, 1.0F);
}

glm::vec3 ColorScale::color(float value) const {
    return color_at(map, place(value));
}

}  // namespace interleaf
