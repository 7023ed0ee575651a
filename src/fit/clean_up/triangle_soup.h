// The first half of the clean-up: turns the triangles of a file into the triangles of one surface.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/progress_meter.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// Per vertex, the first vertex at the same point.
std::vector<Index> first_at_same_point(std::span<const glm::dvec3> positions, ProgressMeter& meter);

/// Removes triangles that use a vertex twice.
/// \return number of triangles removed
std::size_t remove_degenerate(std::vector<Triangle>& triangles);

/// Keeps one of the triangles that have the same three vertices. Where equal numbers look either way, the
/// surface is folded onto itself like a fin and bounds nothing, so none is kept. There are two exceptions,
/// where one is kept: a patch of such triangles closes what would otherwise be a hole; or more than half of
/// all triangles would be removed (in a mesh that has each triangle once per side).
/// \return number of triangles removed
std::size_t remove_duplicates(std::vector<Triangle>& triangles, ProgressMeter& meter);

/// The component of each triangle. Components are numbered from 0 in the order of their first triangles.
std::vector<Index> components_of(std::span<const Index> twin, ProgressMeter& meter);

/// Turns triangles over until each agrees with its neighbors. The first triangle of each component stays.
/// \return           number of triangles turned over
/// \throw InputError naming an edge if the surface is one-sided
std::size_t make_agree(std::vector<Triangle>& triangles, std::vector<Index>& twin, ProgressMeter& meter);

}  // namespace interleaf
