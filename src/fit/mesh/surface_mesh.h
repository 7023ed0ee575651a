// A plain indexed triangle mesh as it comes from a file.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
#include "hierarchy/triangle.h"

namespace interleaf {

struct SurfaceMesh {
    std::vector<glm::dvec3> positions;
    std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside, once clean
    std::vector<glm::vec3> colors;    ///< one a vertex, linear or as given, 0 to 1; empty for none
};

/// The leaves of a key that has passed check(), without colors.
SurfaceMesh surface_of(const Hierarchy& key);

}  // namespace interleaf
