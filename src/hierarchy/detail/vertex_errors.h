// The error per vertex that orders all levels of detail of a hierarchy.
//
// Refine the roots by always bisecting the triangle with the largest deviation, with closure. The error of a
// vertex is the tolerance below which this refinement needs the vertex: the least deviation that it had to
// bisect until it made the vertex. So errors are monotone over what a vertex depends on, also where the
// deviations are not: a vertex never has a larger error than the newest vertices of the triangles that it
// bisects. Vertices that depend on each other in a cycle have equal errors. Hence the vertices with an error
// above any threshold make a conforming hierarchy, and it is the smallest one whose leaves all have a
// deviation of at most the threshold.
#pragma once

#include <span>
#include <vector>

#include "hierarchy/detail/bisection_forest.h"
#include "hierarchy/detail/detail_progress.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

/// The error of each vertex, in the unit of positions; infinity for the vertices of the roots.
/// \pre  the hierarchy passes check()
std::vector<float> vertex_errors(const Hierarchy& hierarchy, const DetailProgress& progress = {});

/// As above.
/// \param forest      bisection_forest() of \p hierarchy
/// \param deviations  deviations() of \p hierarchy
std::vector<float> vertex_errors(const Hierarchy& hierarchy, const BisectionForest& forest,
                                 std::span<const float> deviations, const DetailProgress& progress = {});

}  // namespace interleaf
