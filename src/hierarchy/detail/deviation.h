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

#include <functional>
#include <vector>

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// Receives the fraction of the work that is done, 0 to 1. It may throw, which ends the work. An empty function
/// is never called.
using DetailProgress = std::function<void(double part)>;

/// The deviation of each bisected node, in the order of Hierarchy::midpoints and in the unit of positions,
/// rounded up to a float. Takes time proportional to the sum of the levels of all vertices.
/// \pre  the hierarchy passes check()
std::vector<float> deviations(const Hierarchy& hierarchy, const DetailProgress& progress = {});

}  // namespace interleaf
