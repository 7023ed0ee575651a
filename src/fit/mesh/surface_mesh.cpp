#include "fit/mesh/surface_mesh.h"

#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace interleaf {

double box_diagonal(const SurfaceMesh& mesh) {
    glm::dvec3 least = mesh.positions[0];
    glm::dvec3 largest = least;
    for (const glm::dvec3& position : mesh.positions) {
        least = glm::min(least, position);
        largest = glm::max(largest, position);
    }
    return glm::distance(least, largest);
}

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
