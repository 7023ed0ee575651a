// Moves points over the sphere so that a few of them, the landmarks, reach given places, and all others follow
// smoothly.
//
// The velocity is the field of least energy that moves the landmarks as wanted (landmark matching by flows:
// Glaunes, Vaillant and Miller 2004): a sum of tangential vectors at the landmarks, each times a kernel of
// its distance. The kernel is Wendland's (1 - r)^4 (4 r + 1), which is 0 beyond its radius and needs no
// function whose last bit depends on the machine.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// \param points     unit vectors
/// \param landmarks  indices of \p points, all different
/// \param targets    unit vectors, one per landmark, less than a quarter turn away; the landmarks end at
///                   exactly these
/// \param radius     of the kernel, as a chord of the unit sphere
void flow(std::span<glm::dvec3> points, std::span<const Index> landmarks, std::span<const glm::dvec3> targets,
          double radius);

}  // namespace interleaf
