// Moves positions of any size into the unit box, so that squares and products of lengths neither overflow nor
// vanish.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace interleaf {

/// The positions minus the least corner of their box, scaled by a power of two so that the longest side of
/// the box is from 1/2 to 1 (0 if all positions are equal).
/// \pre all positions are finite, and no coordinate is beyond 1e300
std::vector<glm::dvec3> in_unit_box(std::span<const glm::dvec3> positions);

}  // namespace interleaf
