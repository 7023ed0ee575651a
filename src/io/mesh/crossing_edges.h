// Whether edges in a plane cross: the sweep of Shamos and Hoey, "Geometric intersection problems" (1976).
#pragma once

#include <vector>

#include "io/mesh/polygon_plane.h"

namespace interleaf {

/// An edge of an area that is on its left.
struct PlaneEdge {
    PlanePoint from;
    PlanePoint to;

    bool operator==(const PlaneEdge&) const = default;
    auto operator<=>(const PlaneEdge&) const = default;
};

/// A crossing less deep than this is the rounding of a touch: a millionth of a polygon's size.
inline constexpr double min_depth = 1e-6 * static_cast<double>(plane_steps);

/// Whether two edges may go the same way along one line for a while. Edges of a polygon may, where rounding
/// has it so; edges of triangles that are more than lines may not: the triangles would overlap.
enum class RunningTogether { allowed, forbidden };

/// Whether two edges cross, deeper than min_depth, or go the same way from one place to another. Edges may
/// touch, and an edge may run back along another, as the seam of a keyhole does. Edges without length are
/// left out. Time: n log n.
bool has_crossing(std::vector<PlaneEdge> edges, RunningTogether together);

}  // namespace interleaf
