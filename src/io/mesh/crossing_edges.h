// Finds out whether edges in a plane cross, with the sweep of Shamos and Hoey, "Geometric intersection
// problems" (1976).
#pragma once

#include <vector>

#include "io/mesh/polygon_plane.h"

namespace interleaf {

/// An edge of an area. The area lies to the left of the edge.
struct PlaneEdge {
    PlanePoint from;
    PlanePoint to;

    bool operator==(const PlaneEdge&) const = default;
    auto operator<=>(const PlaneEdge&) const = default;
};

/// A crossing that is less deep than a millionth of the polygon's size counts as a touch with rounding
/// errors.
inline constexpr double min_depth = 1e-6 * static_cast<double>(plane_steps);

/// Whether two edges may overlap in the same direction along one line. Edges of a polygon may, because
/// rounding can cause it. Edges of triangles with an area may not, because the triangles would overlap.
enum class RunningTogether { allowed, forbidden };

/// Whether two edges cross by more than min_depth, or overlap in the same direction where \p together
/// forbids it. Edges may touch, and an edge may run back along another one, as in the seam of a keyhole. The
/// function ignores edges without length. It takes n log n time.
bool has_crossing(std::vector<PlaneEdge> edges, RunningTogether together);

}  // namespace interleaf
