// Colour maps for scalar fields, and scales that say which value has which colour. The shader and the legend
// take them from here, so that they agree. No GL.
//
// Viridis and magma (N. Smith and S. van der Walt, 2015) are perceptually uniform. Coolwarm is the diverging
// map of K. Moreland, "Diverging Color Maps for Scientific Visualization", ISVC 2009: uniform to either side
// of its middle, which is neutral.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include <glm/vec3.hpp>

namespace interleaf {

/// The colour 0xrrggbb, sRGB-encoded, components 0 to 1.
constexpr glm::vec3 from_hex(unsigned rgb) {
    return {static_cast<float>(rgb >> 16 & 0xff) / 255.0F, static_cast<float>(rgb >> 8 & 0xff) / 255.0F,
            static_cast<float>(rgb & 0xff) / 255.0F};
}

enum class ColorMap { viridis, magma, coolwarm };

/// All maps, in the order in which they are offered.
std::span<const ColorMap> color_maps();

/// "viridis".
std::string_view name_of(ColorMap map);

/// The map called \p name; none when there is none.
std::optional<ColorMap> color_map_named(std::string_view name);

/// Whether the map has a middle that means something: the place of 0.
bool is_diverging(ColorMap map);

/// The colour at \p place, 0 to 1 and no further, sRGB-encoded.
glm::vec3 color_at(ColorMap map, float place);

struct ValueRange {
    float min = 0;
    float max = 1;
    bool operator==(const ValueRange&) const = default;
};

/// What colours mean: \p map over \p range. Values outside have the colour of the range's end.
///
/// A diverging map over a range around 0 has its middle at 0, and equal steps to either side: what it has
/// beyond the nearer end of the range is not used.
struct ColorScale {
    ColorMap map = ColorMap::viridis;
    ValueRange range;
    bool operator==(const ColorScale&) const = default;

    /// The place of \p value within the range as an affine map: (value - base) * factor + offset.
    struct Placing {
        float base;
        float factor;
        float offset;
    };
    Placing placing() const;

    glm::vec3 color(float value) const;
};

}  // namespace interleaf
