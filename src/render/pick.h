// Picking: the first triangle that a ray hits. The search looks at every triangle, which takes about a
// millisecond per hundred thousand. So there is no data structure to build, or to update while the surface
// morphs.
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

/// The first point where \p ray hits one of \p triangles, from either side; none if it hits none.
std::optional<Hit> first_hit(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                             const Ray& ray);

}  // namespace interleaf
