// Arrows over a picture.
#pragma once

#include <glm/vec2.hpp>

namespace interleaf {

/// Draws an arrow behind all panels, within the clip rectangle of the background. A short arrow becomes a dot.
/// \param from, to  window coordinates
void arrow_mark(glm::vec2 from, glm::vec2 to);

}  // namespace interleaf
