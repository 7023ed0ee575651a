// The first half of cleaning up: from triangles as a file has them to those of one surface.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/progress_meter.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// For each vertex, the first one at the same point.
std::vector<Index> first_at_same_point(std::span<const glm::dvec3> positions, ProgressMeter& meter);

/// Removes triangles that name a vertex twice; how many.
std::size_t remove_degenerate(std::vector<Triangle>& triangles);

/// Of triangles with the same three vertices, keeps one. Where as many look one way as the other, the surface
/// is folded onto itself and bounds nothing, like a fin, and none is kept; but one is where a patch of such
/// triangles closes what would be a hole without it, or where more than half of all triangles would go (a
/// mesh that has each triangle for both of its sides). How many were removed.
std::size_t remove_duplicates(std::vector<Triangle>& triangles, ProgressMeter& meter);

/// The component of each triangle, numbered from 0 by their first triangles.
std::vector<Index> components_of(std::span<const Index> twin, ProgressMeter& meter);

/// Turns triangles over until each agrees with its neighbors, the first of each component kept as it is; how
/// many. \throw InputError naming an edge when the surface is one-sided
std::size_t make_agree(std::vector<Triangle>& triangles, std::vector<Index>& twin, ProgressMeter& meter);

}  // namespace interleaf
