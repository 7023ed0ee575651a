#include "fit/mesh/surface_mesh.h"

#include <cstddef>

namespace interleaf {

void append_mean(std::vector<MeshField>& scalars, std::span<const Index> vertices,
                 std::span<const double> weights) {
    for (MeshField& scalar : scalars) {
        double mean = 0;
        for (std::size_t k = 0; k < vertices.size(); ++k) mean += weights[k] * scalar.values[vertices[k]];
        scalar.values.push_back(mean);
    }
}

SurfaceMesh surface_of(const Hierarchy& key) {
    SurfaceMesh mesh;
    mesh.positions.assign(key.positions.begin(), key.positions.end());
    mesh.triangles.reserve(key.leaf_count());
    for (const Leaf& leaf : leaves_of(key)) mesh.triangles.push_back(leaf.vertices);
    return mesh;
}

}  // namespace interleaf
