// What the colors of a scale mean: a bar of them with numbers below.
#pragma once

#include <glm/vec2.hpp>

#include "render/color_map.h"

namespace interleaf {

/// The bar, as wide as the present panel.
void scale_legend(const ColorScale& scale);

/// The colors of \p scale alone, over its range, from \p corner on.
void draw_scale_colors(glm::vec2 corner, glm::vec2 size, const ColorScale& scale);

}  // namespace interleaf
