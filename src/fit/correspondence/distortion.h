// The distortion of a map from one surface to another: symmetric Dirichlet energy (Smith and Schaefer 2015),
// weighted by the areas on both surfaces.
#pragma once

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace interleaf {

/// A triangle of the moving mesh, seen from one of its corners, the center: its rest shape on the first surface
/// and its other corners on the second.
struct StretchedTriangle {
    glm::dvec3 a;  ///< the next corner counter-clockwise
    glm::dvec3 b;
    double cotangent_at_center;  ///< of the angles of the rest shape
    double cotangent_at_a;
    double cotangent_at_b;
    double rest_area;
};

/// For the triangle with its center at \p center: rest_area (1 + r)/2 D/2 (1 + 1/r^2)/2. D is the squared
/// stretch, summed over two directions and halved; r is the ratio of the areas. It is rest_area for a triangle
/// that keeps its shape and size.
double distortion_of(const StretchedTriangle& triangle, const glm::dvec3& center);

/// The gradient of an energy of the center's place, in a tangent plane, and its second derivatives without their
/// negative part.
struct TangentDerivatives {
    glm::dvec2 gradient{0};
    glm::dmat2 second{0.0};
};

/// Adds the derivatives of \p factor times distortion_of().
/// \param s,t  orthonormal axes of the tangent plane
/// \return     distortion_of(), to the last bit
double add_distortion_derivatives(const StretchedTriangle& triangle, const glm::dvec3& center,
                                  const glm::dvec3& s, const glm::dvec3& t, double factor,
                                  TangentDerivatives& sum);

}  // namespace interleaf
