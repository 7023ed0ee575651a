// Color maps for scalar fields, and scales that assign colors to values. The shader and the legend both use
// them, so they agree. No GL.
//
// Viridis and magma (N. Smith and S. van der Walt, 2015) are perceptually uniform. Coolwarm is the diverging
// map of K. Moreland, "Diverging Color Maps for Scientific Visualization", ISVC 2009. It is uniform on either
// side of its middle, which is neutral.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include <glm/vec3.hpp>

namespace interleaf {

/// The color 0xrrggbb, sRGB-encoded, components 0 to 1.
constexpr glm::vec3 from_hex(unsigned rgb) {
    return {static_cast<float>(rgb >> 16 & 0xff) / 255.0F, static_cast<float>(rgb >> 8 & 0xff) / 255.0F,
            static_cast<float>(rgb & 0xff) / 255.0F};
}

enum class ColorMap { viridis, magma, coolwarm };

/// All maps, in the order in which they are offered.
std::span<const ColorMap> color_maps();

/// For example, "viridis".
std::string_view name_of(ColorMap map);

/// The map called \p name; none if there is none.
std::optional<ColorMap> color_map_named(std::string_view name);

/// Whether the middle of the map has a meaning: it is the place of 0.
bool is_diverging(ColorMap map);

/// The color at \p place, clamped to 0 to 1; sRGB-encoded.
glm::vec3 color_at(ColorMap map, float place);

struct ValueRange {
    float min = 0;
    float max = 1;
    bool operator==(const ValueRange&) const = default;
};

/// The meaning of colors: \p map over \p range. Values outside get the color of the nearer end of the range.
///
/// A diverging map over a range around 0 has its middle at 0 and equal steps on either side. So the part of
/// the map beyond the nearer end of the range is not used. With an offset, the scale has no such middle, and is not
/// logarithmic: all values are then about as large as the offset.
struct ColorScale {
    ColorMap map = ColorMap::viridis;
    ValueRange range;
    bool is_logarithmic = false;  ///< equal steps are equal factors, if the range is above 0
    double offset = 0;  ///< is added to values where they are shown; range and colors are without it
    bool operator==(const ColorScale&) const = default;

    bool uses_logarithm() const {
        return is_logarithmic && range.min > 0 && range.max > range.min && offset == 0;
    }

    /// The place of a value, or of its natural logarithm, within the range as an affine map:
    /// (value - base) * factor + offset.
    struct Placing {
        float base;
        float factor;
        float offset;
    };
    Placing placing() const;

    /// The place of \p value, 0 to 1.
    float place(float value) const;

    glm::vec3 color(float value) const;
};

}  // namespace interleaf
