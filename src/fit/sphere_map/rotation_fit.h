// The rotation that turns some directions best into others (Kabsch 1976; the form with a quaternion: Horn
// 1987, "Closed-form solution of absolute orientation using unit quaternions").
#pragma once

#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace interleaf {

struct RotationFit {
    glm::dmat3 rotation{1};
    double agreement = 0;  ///< the sum of (R from) . to, which the rotation R maximizes
    double mirrored = 0;   ///< the largest such sum of a rotation followed by a reflection at the origin
    /// The agreement minus the next eigenvalue of Horn's matrix: 0 if several rotations are equally good, as for
    /// directions along one line.
    double margin = 0;
};

/// \param from  vectors of any length; longer ones count more
/// \param to    one vector per vector of \p from
RotationFit fit_rotation(std::span<const glm::dvec3> from, std::span<const glm::dvec3> to);

}  // namespace interleaf
