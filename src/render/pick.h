// What is under the pointer: the first triangle that a ray meets. It looks at every triangle, which takes
// about a millisecond for a hundred thousand; there is nothing to build and to keep while the surface morphs.
#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// The points from \p from to \p to.
struct Ray {
    glm::vec3 from;
    glm::vec3 to;
};

struct Hit {
    std::size_t triangle;
    glm::vec3 barycentric;  ///< of the point, within the triangle
};

/// Where \p ray first meets one of \p triangles, from either side; none if it meets none.
std::optional<Hit> first_hit(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                             const Ray& ray);

}  // namespace interleaf
