// How much a surface is stretched that began as another one.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// The stretch of a triangle: the larger singular value of the affine map that takes the triangle \p before
/// to the triangle \p now. It is the largest factor by which a length in the triangle has grown. 0 if the
/// triangle \p before has no area.
double stretch_of(std::span<const glm::dvec3, 3> before, std::span<const glm::dvec3, 3> now);

/// Per vertex, the mean stretch of its triangles, weighted by their areas before.
/// \param before, now  positions by vertex, of the same length
std::vector<float> vertex_stretches(std::span<const Triangle> triangles, std::span<const glm::dvec3> before,
                                    std::span<const glm::dvec3> now);

}  // namespace interleaf
