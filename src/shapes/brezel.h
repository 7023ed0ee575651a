// The brezel, a surface of genus 2 over 144 root triangles, as many as the brezel of the paper's appendix
// has.
//
// A plate of 6 x 4 unit cubes with two holes of 1 x 2 is blurred by a Gaussian; the surface is where the
// density is 0.45. The roots are the plate's boundary: its 72 squares, each split by a diagonal, which is the
// refinement edge on both sides. So the marking is compatible, and right isosceles triangles are bisected
// into such. Points get onto the surface by Newton's method along the gradient.
#pragma once

#include <glm/vec3.hpp>

#include "shapes/base_surface.h"

namespace interleaf {

/// The plate's density, blurred; it is brezel_level on the surface.
struct BrezelDensity {
    double value;         ///< 1 deep inside, 0 far outside
    glm::dvec3 gradient;  ///< towards the inside
};

inline constexpr double brezel_level = 0.45;

/// The density at \p point. The plate's centre is the origin, its faces look towards +z and -z.
BrezelDensity brezel_density(const glm::dvec3& point);

/// The plate's boundary: 144 triangles, counter-clockwise seen from outside, and 70 vertices, at the cubes'
/// corners.
Hierarchy brezel_plate();

/// \p point moved along gradients to where the density is brezel_level, to the precision of doubles.
/// \pre  the point is on the plate's boundary, or the density there is 0.15 to 0.75, as it is on all
/// triangles that roots are bisected into
glm::dvec3 project_to_brezel(const glm::dvec3& point);

inline constexpr BaseSurface brezel{brezel_plate, project_to_brezel};

/// The brezel itself, as a map from its base surface.
inline glm::dvec3 brezel_surface(const glm::dvec3& point) {
    return point;
}

}  // namespace interleaf
