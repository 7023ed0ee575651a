// The rotation that turns some directions best into others (Kabsch 1976; the form with a quaternion: Horn
// 1987, "Closed-form solution of absolute orientation using unit quaternions").
#pragma once

#include <span>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace interleaf {

struct RotationFit {
    glm::dquat quaternion{1, 0, 0, 0};  ///< the rotation R
    glm::dmat3 rotation{1};             ///< the same as a matrix
    double agreement = 0;               ///< the sum of (R from) . to, which R maximizes
    double mirrored = 0;  ///< the largest such sum of a rotation followed by a reflection at the origin
    /// The agreement minus the next eigenvalue of Horn's matrix: 0 if several rotations are equally good, as for
    /// directions along one line.
    double margin = 0;
};

/// \param products  the sum of the outer products, products[j][i] of from_i and to_j
RotationFit fit_rotation(const glm::dmat3& products);

/// \param from  vectors of any length; longer ones count more
/// \param to    one vector per vector of \p from
RotationFit fit_rotation(std::span<const glm::dvec3> from, std::span<const glm::dvec3> to);

}  // namespace interleaf
