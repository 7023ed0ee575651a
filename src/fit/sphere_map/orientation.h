// The orientation of three directions, with the sign that exact arithmetic would give.
//
// A filter in double precision decides nearly all cases. The others are decided by summing the exact products
// as expansions of doubles (Shewchuk 1997).
#pragma once

#include <glm/vec3.hpp>

namespace interleaf {

/// The sign, 1, 0 or -1, of det(a, b, c) for exactly these vectors: positive if the spherical triangle a b c
/// runs counter-clockwise seen from outside.
/// \pre coordinates are within 1e-60 to 1e60, or 0
int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace interleaf
