// The base of a key: root triangles, and the surface that their bisection follows.
//
// A new vertex is the midpoint of its edge, projected onto the surface. So a vertex of a key stands for a
// point of the base surface, and a shape is a map from there. Keys over the same base have the same roots, so
// they can be morphed.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
#include "shapes/icosahedron.h"

namespace interleaf {

struct BaseSurface {
    Hierarchy (*roots)();                            ///< unrefined; their vertices are on or near the surface
    glm::dvec3 (*project)(const glm::dvec3& point);  ///< from near the surface onto it
};

inline glm::dvec3 project_to_unit_sphere(const glm::dvec3& point) {
    return glm::normalize(point);
}

/// The unit sphere over the icosahedron's triangles.
inline constexpr BaseSurface unit_sphere{icosahedron, project_to_unit_sphere};

}  // namespace interleaf
