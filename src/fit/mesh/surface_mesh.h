// A plain indexed triangle mesh as it comes from a file.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
#include "hierarchy/triangle.h"

namespace interleaf {

struct SurfaceMesh {
    std::vector<glm::dvec3> positions;
    std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside, once the mesh is clean
    std::vector<glm::vec3> colors;    ///< one per vertex, linear or as in the file, 0 to 1; empty if none
};

/// The leaves of a key, without colors.
/// \pre \p key has passed check()
SurfaceMesh surface_of(const Hierarchy& key);

}  // namespace interleaf
