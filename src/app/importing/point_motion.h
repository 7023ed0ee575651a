// How far corresponding points of two keys move, against how far the surface itself moves.
#pragma once

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// Means over the area of the first key, as parts of the diagonal of its box.
struct PointMotion {
    double points = 0;   ///< distance between corresponding points
    double surface = 0;  ///< distance of the points of the first key from the second key's surface
};

/// The motion from \p from to \p to, at the vertices of their union. Where points slide along the surface, they move
/// further than the surface does: for a sphere that moves by less than its size, twice as far.
/// \pre  both have the same roots
PointMotion motion_of_points(const Hierarchy& from, const Hierarchy& to);

}  // namespace interleaf
