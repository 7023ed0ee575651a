// The legend of a color scale: a bar of its colors, with numbers below.
#pragma once

#include <glm/vec2.hpp>

#include "render/color_map.h"

namespace interleaf {

/// Shows the legend, as wide as the current panel.
void scale_legend(const ColorScale& scale);

/// Draws only the colors of \p scale, over its range.
/// \param corner  upper left corner
void draw_scale_colors(glm::vec2 corner, glm::vec2 size, const ColorScale& scale);

/// Shows the ends of the range of \p scale as two fields, and takes what is typed. Ignores ends that are no range, as
/// they may be while the user types.
void edit_range(ColorScale& scale);

}  // namespace interleaf
