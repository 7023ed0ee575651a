// The legend in pictures and films that are written to files: what their colors mean, below a title. It is a bar with
// numbers for values and levels, else a list. Within a film it keeps its width, so that the surface stays in its place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "family/family_fields.h"
#include "hierarchy/union_mesh.h"
#include "render/color_map.h"
#include "render/display.h"
#include "render/palette.h"

namespace interleaf {

/// A color and what it means.
struct LegendEntry {
    glm::vec3 color;  ///< sRGB-encoded
    std::string text;
    bool operator==(const LegendEntry&) const = default;
};

struct PictureLegend {
    std::string title;  ///< "speed (m/s)"
    std::variant<ColorScale, LevelRange, std::vector<LegendEntry>> colors;
    bool is_light = false;  ///< dark text on light ground
    bool operator==(const PictureLegend&) const = default;
};

/// Whether the colors of \p display have a legend.
bool has_picture_legend(const Display& display, std::span<const FamilyField> fields);

/// The legend of \p display.
/// \param names  of all keys of the family
/// \param keys   the active ones
/// \param mesh   their union
/// \pre has_picture_legend()
PictureLegend picture_legend(const Display& display, std::span<const FamilyField> fields,
                             std::span<const std::string> names, std::span<const std::size_t> keys,
                             const UnionMesh& mesh);

/// The part of the picture's width, from its right side, in which draw_legend() draws; 0 if it draws nothing.
float legend_part(int width, int height, const PictureLegend& legend);

/// Draws \p legend at the right side of a picture, as large as suits the size of the picture. Does nothing if the
/// picture has no room for it.
/// \param rgba  8 bits per channel, sRGB-encoded, top row first; 4 \p width \p height bytes
void draw_legend(std::span<std::uint8_t> rgba, int width, int height, const PictureLegend& legend);

}  // namespace interleaf
