// The transfer function of sRGB (IEC 61966-2-1). Colors are stored encoded, as in files and on screens.
// Addition, averaging and lighting use linear light.
#pragma once

#include <glm/vec3.hpp>

namespace interleaf {

/// Converts an sRGB-encoded color, components 0 to 1, to linear light.
glm::vec3 linear_light(glm::vec3 color);

/// The inverse of linear_light().
glm::vec3 encoded(glm::vec3 light);

}  // namespace interleaf
