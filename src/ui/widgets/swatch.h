// The square of color beside a name.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

struct ImDrawList;

namespace interleaf {

/// Side of a swatch; screen coordinates.
float swatch_side();

/// Draws a square of the sRGB-encoded \p color in the middle of a line of text. Its rim keeps it visible on a
/// ground of the same color.
/// \param corner  the upper left corner of the line
/// \param height  of the line, screen coordinates
void draw_swatch(ImDrawList& list, glm::vec2 corner, float height, glm::vec3 color);

}  // namespace interleaf
