// Makes the key of a step whose triangles are the leaves of a hierarchy.
#pragma once

#include <span>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "sequence/series/step_mesh.h"

namespace interleaf {

/// The key whose leaves are the triangles of \p step, with the positions and the scalars of the step.
/// \param roots          the root complex
/// \param root_vertices  the vertex of the step at each root vertex
/// \param leaves         in preorder, with the vertices of the step; \p step has no other vertices
/// \param fields         names the scalars of the step
Hierarchy key_of_step(const StepMesh& step, const RootComplex& roots, std::span<const Index> root_vertices,
                      std::vector<Leaf> leaves, const SeriesFields& fields);

}  // namespace interleaf
