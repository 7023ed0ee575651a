// The cube, whose squares are the roots of spheres and of fitted surfaces.
#pragma once

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// The squares of a cube, each halved by a diagonal: 12 right isosceles triangles, not bisected. The diagonals
/// are the refinement edges. These triangles keep their shape under bisection; equilateral ones do not.
///
/// Vertex v is the corner whose coordinate along axis n is 1 where bit n of v is set, -1 elsewhere.
Hierarchy cube();

}  // namespace interleaf
