// The legend in pictures and films that are written to files: the colors of the shown scalar with numbers, below a
// title of its name and unit.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "family/family_fields.h"
#include "render/color_map.h"
#include "render/display.h"

namespace interleaf {

struct PictureLegend {
    std::string title;  ///< "speed (m/s)"
    ColorScale scale;
    bool operator==(const PictureLegend&) const = default;
};

/// The legend of the scalar that \p display shows; none if it shows none.
std::optional<PictureLegend> picture_legend(const Display& display, std::span<const FamilyField> fields);

/// The part of the picture's width, from its right side, in which draw_legend() draws; 0 if it draws nothing.
float legend_part(int width, int height, const PictureLegend& legend);

/// Draws \p legend at the right side of a picture, as large as suits the size of the picture. Does nothing if the
/// picture has no room for it.
/// \param rgba  8 bits per channel, sRGB-encoded, top row first; 4 \p width \p height bytes
void draw_legend(std::span<std::uint8_t> rgba, int width, int height, const PictureLegend& legend);

}  // namespace interleaf
