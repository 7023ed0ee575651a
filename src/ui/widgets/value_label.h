// The label beside the pointer that shows the value of a field.
#pragma once

#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "ui/widgets/rect.h"

namespace interleaf {

/// Shows \p text beside \p pointer, within \p area, with a swatch of the sRGB-encoded \p color.
void value_label(glm::vec2 pointer, const Rect& area, glm::vec3 color, std::string_view text);

}  // namespace interleaf
