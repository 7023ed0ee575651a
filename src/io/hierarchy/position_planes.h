// The positions of a key as byte planes: the difference of each position from its expected position.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "hierarchy/buffer.h"
#include "io/hierarchy/bisection_decisions.h"
#include "io/hierarchy/coordinate_grid.h"

namespace interleaf {

/// The differences of \p positions from the expected positions, as BytePlanes: one row per vertex, in
/// prediction_order(). The first root vertex is expected at the origin, and every other root vertex at the
/// position of the previous one.
/// \param grid  the grid that contains all \p positions: coordinates are counted in its steps. Without a
///              grid, a coordinate is its rank among all floats, so neighboring floats differ by 1.
Buffer<std::byte> position_planes(std::span<const glm::vec3> positions, const Connectivity& connectivity,
                                  const std::optional<CoordinateGrid>& grid);

/// The positions whose differences are \p planes, one per vertex. Any content of \p planes gives positions.
Buffer<glm::vec3> positions_of(std::span<std::byte> planes, const Connectivity& connectivity,
                               const std::optional<CoordinateGrid>& grid);

}  // namespace interleaf
