// The unit normals of a surface's triangles, and what they say of a leaf over them.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/sphere_location.h"
#include "fit/surface_sampling.h"
#include "fit/triangle_distance.h"

namespace interleaf {

/// Zero for a triangle of no area.
glm::dvec3 unit_normal(const TriangleCorners& corners);

/// One a triangle.
std::vector<glm::dvec3> unit_normals(std::span<const Triangle> triangles,
                                     std::span<const glm::dvec3> positions);

/// Whether the normal of a leaf does not point to the side of the surface's normal there: the mean over a few
/// places of the leaf, by the map. A leaf of no area counts.
/// \param leaf      vertices of \p surface
/// \param normals   those of the triangles that \p location locates
bool is_turned_over(const Triangle& leaf, const SampledSurface& surface, const SphereLocation& location,
                    std::span<const glm::dvec3> normals);

}  // namespace interleaf
