// The transfer function of sRGB (IEC 61966-2-1). Colours are kept encoded, as files and screens have them,
// and added, averaged and lit as light.
#pragma once

#include <glm/vec3.hpp>

namespace interleaf {

/// An sRGB-encoded colour, components 0 to 1, as linear light.
glm::vec3 linear_light(glm::vec3 color);

/// The inverse of linear_light().
glm::vec3 encoded(glm::vec3 light);

}  // namespace interleaf
