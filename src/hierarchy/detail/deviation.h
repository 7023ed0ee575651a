// The deviation of a bisected triangle from the surface below it: what is lost where the triangle becomes a
// leaf.
//
// The deviation is the largest of these distances, over all vertices below the triangle: of a vertex inside
// from the triangle, and of a vertex on one of the triangle's edges from that edge. It bounds the Hausdorff
// distance, in both directions. To see this, map each vertex below to its nearest point of the triangle or of
// the edge, and extend the map linearly over each leaf. A point of the surface moves by at most the deviation,
// because the way that it moves is linear over a leaf. The map takes each side of the surface onto the edge
// between the same two corners, so it takes the surface onto the whole triangle. docs/theory.md has the
// details.
#pragma once

#include <vector>

#include "hierarchy/detail/detail_progress.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

/// The deviation of each bisected node, in the order of Hierarchy::midpoints and in the unit of positions,
/// rounded up to a float. Takes time proportional to the sum of the levels of all vertices.
/// \pre  the hierarchy passes check()
std::vector<float> deviations(const Hierarchy& hierarchy, const DetailProgress& progress = {});

}  // namespace interleaf
