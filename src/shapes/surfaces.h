// The surfaces of the analytic keys (paper, figure 8): each maps a point of the unit sphere to a point of a
// closed surface.
#pragma once

#include <glm/vec3.hpp>

namespace interleaf {

/// A map from a base surface to a surface, one to one, keeping the orientation. The base is the unit sphere
/// unless stated otherwise.
using Surface = glm::dvec3 (*)(const glm::dvec3& u);

/// The unit sphere itself.
glm::dvec3 sphere_surface(const glm::dvec3& u);

/// Z^2 = 0.55^2 (1 - X^2)(1 - Y^2), intersected with the ray through \p u.
glm::dvec3 cushion_surface(const glm::dvec3& u);

/// An arm towards each of the icosahedron's 12 vertices d: radius 0.62 + 0.95 * sum over d of exp(22 (u.d -
/// 1)).
glm::dvec3 star_surface(const glm::dvec3& u);

/// A bone along the x axis, with two knobs at each end, at +y and -y.
glm::dvec3 bone_surface(const glm::dvec3& u);

}  // namespace interleaf
