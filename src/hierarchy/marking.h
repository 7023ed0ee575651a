// Marking of the refinement edges of a root complex (paper, section 2, algorithm (A)).
//
// Any marking works. Two are offered: the longest edge (Rivara 1984), and a compatible one. Under a
// compatible marking, a triangle and its neighbor across its refinement edge share that refinement edge, so
// closure stays local, and leaves that share an edge differ by at most one level. A compatible marking is a
// perfect matching of the dual graph; by Petersen's theorem one exists on every closed surface. On an open
// surface the doubled surface is matched, so that a boundary edge may be a refinement edge.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/root_complex.h"

namespace interleaf {

/// The complex with each triple rotated so that its longest edge is opposite the first vertex. Of equal edges
/// the earlier one counts.
/// \param positions  one per vertex
RootComplex mark_longest_edges(const RootComplex& roots, std::span<const glm::vec3> positions);

/// The complex with its triples rotated to a compatible marking. Takes time quadratic in the number of
/// triangles (maximum matching).
RootComplex mark_compatibly(const RootComplex& roots);

/// Whether every triangle's neighbor across its refinement edge has the same refinement edge.
bool is_compatibly_marked(const RootComplex& roots);

}  // namespace interleaf
