// Root complexes over the unit sphere, over which surfaces are sampled.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// A cube's squares, each halved by a diagonal: 12 right isosceles triangles with the diagonals as refinement
/// edges, not bisected. They keep their shape under bisection, which equilateral ones do not.
Hierarchy cube();

/// The octahedron's 8 triangles, not bisected; the refinement edges are those of its equator.
Hierarchy octahedron();

struct SphereRoots {
    RootComplex complex;
    std::vector<glm::dvec3> points;  ///< of the unit sphere, one a root vertex
};

/// The roots of \p hierarchy with their vertices projected onto the unit sphere from the middle of their box.
/// \throw InputError saying why, where the triangles then do not cover the sphere once
SphereRoots project_to_sphere(const Hierarchy& hierarchy);

}  // namespace interleaf
