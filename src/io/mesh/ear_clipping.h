// Divides polygons into triangles by clipping ears: corners whose triangle with their neighbors holds no
// other corner (Meisters, "Polygons have ears", 1975). Of all ears the one with the shortest diagonal goes
// first, so that a round polygon does not become a fan of needles.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// Corners that a polygon of a file has at most.
inline constexpr std::size_t max_polygon_corners = 100'000;

/// The triangles of a polygon in the plane that fits it best, as numbers of its corners, two triangles fewer
/// than corners; none where it is flat and crosses itself. It may be concave, and touch itself at corners or
/// along edges, as where a seam leads to a hole. A polygon without area becomes triangles without area.
/// Whether it crosses itself is sure where edges cross; where it only passes through itself at corners on its
/// edges, rounding may hide it. \pre 3 to max_polygon_corners corners, finite
std::vector<Triangle> divide_polygon(std::span<const glm::dvec3> corners);

}  // namespace interleaf
