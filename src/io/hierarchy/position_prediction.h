// Predicts the position of a midpoint from earlier vertices. The file stores positions relative to
// predictions.
//
// Vertices are taken level by level. So a midpoint is the center of a square of known vertices: the ends of
// its edge, and the apexes of the two triangles beside that edge. The younger end y of the edge is itself the
// midpoint of an edge, and one of the square's diagonals runs along that edge. The distance of y from the
// middle of its edge shows how much the surface bends in that direction. The diagonal is half as long, so it
// bends a quarter as much:
//
//     middle of the diagonal's ends + (y - middle of the ends of y's edge) / 4
//
// Where the diagonal is the edge itself, this is the parabola through three vertices in a row. If a fourth
// vertex lies in the same row, the prediction uses the cubic through all four. The errors of parabola and
// cubic are of third and fourth order in the edge length; the error of the plain middle is of second order.
//
// Everything is computed in double precision, with plain additions and products without contraction, so the
// bits are the same on every machine.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "hierarchy/buffer.h"
#include "io/hierarchy/bisection_decisions.h"

namespace interleaf {

/// All vertices in the order in which they are predicted: root vertices first, then by level, and by index
/// within a level. The ends of a midpoint's edge come before the midpoint.
/// \param levels  of the vertices (Connectivity::levels)
Buffer<Index> prediction_order(std::span<const std::uint8_t> levels);

/// The expected position of the midpoint \p vertex.
/// \param positions  read only at vertices that come before \p vertex in prediction_order()
glm::dvec3 predicted_position(Index vertex, const Connectivity& connectivity,
                              std::span<const glm::vec3> positions);

}  // namespace interleaf
