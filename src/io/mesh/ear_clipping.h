// Divides polygons into triangles by ear clipping. An ear is a corner whose triangle with its two neighbors
// contains no other corner (Meisters, "Polygons have ears", 1975). The ear with the shortest diagonal is
// clipped first, so that a round polygon does not become a fan of needles.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// The largest number of corners of a polygon in a file.
inline constexpr std::size_t max_polygon_corners = 100'000;

/// Divides a polygon into triangles, in the plane that fits the polygon best. A polygon may be concave, and
/// may touch itself at corners or along edges, for instance where a seam leads to a hole. A polygon without
/// area becomes triangles without area.
///
/// The function always detects that a flat polygon crosses itself where edges cross. Where the polygon only
/// passes through itself at a corner that lies on an edge, rounding may hide the crossing.
/// \return the triangles, as numbers of corners, two triangles fewer than corners; empty if the polygon is
///         flat and crosses itself
/// \pre    3 to max_polygon_corners corners, all finite
std::vector<Triangle> divide_polygon(std::span<const glm::dvec3> corners);

}  // namespace interleaf
