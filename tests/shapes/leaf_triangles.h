// The leaves of a key as a plain mesh.
#pragma once

#include <vector>

#include "hierarchy/hierarchy.h"

namespace interleaf {

inline std::vector<Triangle> leaf_triangles(const Hierarchy& key) {
    std::vector<Triangle> triangles;
    for (const Leaf& leaf : leaves_of(key)) triangles.push_back(leaf.vertices);
    return triangles;
}

}  // namespace interleaf
