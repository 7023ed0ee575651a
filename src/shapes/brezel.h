// The brezel, a surface of genus 2 over 144 root triangles, as many as the brezel of the paper's appendix
// has.
//
// A plate of 6 x 4 unit cubes with two holes of 1 x 2 is blurred by a Gaussian; the surface is where the
// density is 0.45. The roots are the plate's boundary: its 72 squares, each split by a diagonal, which is the
// refinement edge on both sides. So the marking is compatible, and the bisection of right isosceles triangles
// gives such triangles again. Newton's method along the gradient projects points onto the surface.
#pragma once

#include <glm/vec3.hpp>

#include "shapes/base_surface.h"

namespace interleaf {

/// The plate's blurred density; it equals brezel_level on the surface.
struct BrezelDensity {
    double value;         ///< 1 deep inside, 0 far outside
    glm::dvec3 gradient;  ///< towards the inside
};

inline constexpr double brezel_level = 0.45;

/// The density at \p point. The plate's center is the origin, its faces point towards +z and -z.
BrezelDensity brezel_density(const glm::dvec3& point);

/// The plate's boundary: 144 triangles, counter-clockwise seen from outside, and 70 vertices, at the cubes'
/// corners.
Hierarchy brezel_plate();

/// \p point moved along gradients to a place where the density is brezel_level, to the precision of doubles.
/// \pre  the point is on the plate's boundary, or the density there is 0.15 to 0.75; all triangles that the
///     roots are bisected into satisfy this
glm::dvec3 project_to_brezel(const glm::dvec3& point);

inline constexpr BaseSurface brezel{brezel_plate, project_to_brezel};

/// The brezel itself, as a map from its base surface.
inline glm::dvec3 brezel_surface(const glm::dvec3& point) {
    return point;
}

}  // namespace interleaf
