// Root complexes over the unit sphere, over which surfaces are sampled.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// The 8 triangles of an octahedron, not bisected. The refinement edges are the edges of the equator.
Hierarchy octahedron();

struct SphereRoots {
    RootComplex complex;
    std::vector<glm::dvec3> points;  ///< of the unit sphere, one per root vertex
};

/// The roots of \p hierarchy, with their vertices projected onto the unit sphere from the middle of their
/// box.
/// \throw InputError saying why, if the projected triangles do not cover the sphere once
SphereRoots project_to_sphere(const Hierarchy& hierarchy);

}  // namespace interleaf
