// Recomputes, from a key over the icosahedron alone, the points of the unit sphere that its vertices are
// images of.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"

namespace interleaf {

struct SphereLeaf {
    std::array<glm::dvec3, 3> on_sphere;
    std::array<glm::dvec3, 3> on_key;
};

/// The leaves of a key over the icosahedron, in preorder.
std::vector<SphereLeaf> sphere_leaves(const Hierarchy& key);

}  // namespace interleaf
