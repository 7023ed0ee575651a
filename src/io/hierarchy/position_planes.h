// The positions of a key as byte planes: what each differs by from the position that is expected there.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "hierarchy/buffer.h"
#include "io/hierarchy/bisection_decisions.h"
#include "io/hierarchy/coordinate_grid.h"

namespace interleaf {

/// The differences of \p positions, one row a vertex in prediction_order(), as BytePlanes holds them. A
/// coordinate counts in steps of \p grid, on which all of \p positions lie; without a grid as its place among
/// all floats, so that neighboring floats differ by 1. The first root vertex is expected at the origin, each
/// other one where the one before it is.
Buffer<std::byte> position_planes(std::span<const glm::vec3> positions, const Connectivity& connectivity,
                                  const std::optional<CoordinateGrid>& grid);

/// The positions whose differences are \p planes; one a vertex. Whatever \p planes holds, some positions come
/// out.
Buffer<glm::vec3> positions_of(std::span<std::byte> planes, const Connectivity& connectivity,
                               const std::optional<CoordinateGrid>& grid);

}  // namespace interleaf
