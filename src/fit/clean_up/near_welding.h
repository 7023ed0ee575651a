// Joins the vertices along seams whose two sides were written with different roundings.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/progress_meter.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// The largest distance over which vertices are joined, as a fraction of the diagonal of the box, and of the
/// shortest edge at either vertex. So no triangle loses a corner. The two sides of a wall stay apart, however
/// thin the wall is, where triangles lead from one side to the other.
inline constexpr double welding_part_of_size = 1e-5;
inline constexpr double welding_part_of_edge = 0.05;

/// Joins boundary vertices (at edges of only one triangle) that are nearly at the same place. \p triangles
/// then use the first vertex of each group. Vertices inside a surface never move, so closed surfaces stay as
/// they are.
/// \param positions  finite, of any size; equal ones have been joined
/// \return           number of vertices that were merged into another
std::size_t weld_nearby(std::span<const glm::dvec3> positions, std::vector<Triangle>& triangles,
                        ProgressMeter& meter);

}  // namespace interleaf
