// The distance of a point from a triangle in space (Ericson, Real-Time Collision Detection, 2005, section
// 5.1.5: the regions of the triangle's plane).
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace interleaf {

/// The corners of a triangle in space.
using TriangleCorners = std::array<glm::dvec3, 3>;

/// The square of the distance of \p point from the closed triangle with these corners, which may be
/// degenerate.
double squared_distance_to_triangle(const glm::dvec3& point, const TriangleCorners& corners);

}  // namespace interleaf
