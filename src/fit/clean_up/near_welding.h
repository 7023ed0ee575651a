// Joins the vertices along seams whose two sides were written with different roundings.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/progress_meter.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// The largest distance over which vertices are joined: a part of the diagonal of the box, and of the
/// shortest edge at either. So no triangle loses a corner, and the two sides of a wall stay apart, however
/// thin it is, where triangles lead from one to the other.
inline constexpr double welding_part_of_size = 1e-5;
inline constexpr double welding_part_of_edge = 0.05;

/// Joins vertices at edges of only one triangle that are nearly at one place: \p triangles name the first of
/// them. Vertices inside a surface never move, so what is closed stays as it is.
/// \param positions  finite, of any size; equal ones have been joined
/// \return           how many vertices went into another
std::size_t weld_nearby(std::span<const glm::dvec3> positions, std::vector<Triangle>& triangles,
                        ProgressMeter& meter);

}  // namespace interleaf
