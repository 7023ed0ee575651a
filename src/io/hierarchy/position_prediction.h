// Where a midpoint is expected, from vertices that come before it: what its position is stored relative to.
//
// Vertices are taken level by level, so that a midpoint is the center of a square of known vertices: the ends
// of its edge and the apexes of the two triangles beside it. The younger end y of the edge was itself put on
// an edge, which one of the square's diagonals runs along; how far y stands off that edge's middle tells how
// much the surface bends in that direction, and the diagonal, half as long, bends a quarter of that:
//
//     middle of the diagonal's ends + (y - middle of the ends of y's edge) / 4
//
// Where the diagonal is the edge itself, that is the parabola through three vertices in a row. When a fourth
// one lies in the same row, it becomes the cubic through all four. The error is of third and fourth order
// in the edge length, against the second of the plain middle.
//
// Everything is in double precision, and plain additions and products without contraction: the same bits on
// every machine.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "hierarchy/buffer.h"
#include "io/hierarchy/bisection_decisions.h"

namespace interleaf {

/// All vertices, root vertices first, then by level, those of one level by index. The ends of a midpoint's
/// edge come before it.
Buffer<Index> prediction_order(std::span<const std::uint8_t> levels);

/// The position expected of the midpoint \p vertex. \p positions are read at vertices that come before it.
glm::dvec3 predicted_position(Index vertex, const Connectivity& connectivity,
                              std::span<const glm::vec3> positions);

}  // namespace interleaf
