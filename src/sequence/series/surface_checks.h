// The checks that a step is a conforming, orientable manifold, with its neighbors and its orientation.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "sequence/series/step_mesh.h"

namespace interleaf {

/// Sets the neighbors of \p step.
/// \throw InputError  if an edge belongs to more than two triangles, or two triangles have the same corners
void find_neighbors(StepMesh& step);

/// A vertex that lies on an edge of the boundary without being one of its ends, between the edge and the
/// triangles on its other side; none if \p step conforms.
/// \pre  the neighbors are set
std::optional<glm::dvec3> hanging_vertex(const StepMesh& step);

/// Checks that the triangles around each vertex form one fan.
/// \throw InputError  naming a vertex that joins several fans
/// \pre  the neighbors are set
void require_fans(const StepMesh& step);

/// Sets which triangles of \p step are reversed: by their areas if it is flat, or else by flooding each component
/// from its first triangle.
/// \throw InputError  naming a place, if a component cannot be oriented
/// \pre  the neighbors are set
void orient(StepMesh& step);

}  // namespace interleaf
