#include "fit/mesh/surface_mesh.h"

namespace interleaf {

SurfaceMesh surface_of(const Hierarchy& key) {
    SurfaceMesh mesh;
    mesh.positions.assign(key.positions.begin(), key.positions.end());
    mesh.triangles.reserve(key.leaf_count());
    for (const Leaf& leaf : leaves_of(key)) mesh.triangles.push_back(leaf.vertices);
    return mesh;
}

}  // namespace interleaf
