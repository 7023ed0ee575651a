// Whether a polygon crosses itself: the sweep of Shamos and Hoey, "Geometric intersection problems" (1976).
#pragma once

#include <span>

#include "io/polygon_plane.h"

namespace interleaf {

/// Whether two edges of the polygon with \p corners cross, or go the same way from one place to another.
/// Edges may touch, and an edge may run back along another, as the seam of a keyhole does. Crossings less
/// deep than a millionth of the polygon's size are roundings of a touch and do not count. Time: n log n.
bool has_crossing_edges(std::span<const PlanePoint> corners);

}  // namespace interleaf
