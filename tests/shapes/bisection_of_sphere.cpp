#include "shapes/bisection_of_sphere.h"

#include <glm/geometric.hpp>

#include "hierarchy/union_mesh.h"
#include "shapes/icosahedron.h"

namespace interleaf {

std::vector<SphereLeaf> sphere_leaves(const Hierarchy& key) {
    const std::array<const Hierarchy*, 1> keys{&key};
    const UnionMesh mesh = unite(keys);
    std::vector<glm::dvec3> on_sphere;
    for (const glm::dvec3 corner : icosahedron().positions) on_sphere.push_back(glm::normalize(corner));
    for (std::size_t v = on_sphere.size(); v < mesh.vertex_count(); ++v) {
        const auto& [a, b] = mesh.vertices[v].edge;
        on_sphere.push_back(glm::normalize(on_sphere[a] + on_sphere[b]));
    }
    std::vector<SphereLeaf> leaves;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& positions = mesh.positions[0];
        leaves.push_back(
            {{on_sphere[a], on_sphere[b], on_sphere[c]}, {positions[a], positions[b], positions[c]}});
    }
    return leaves;
}

}  // namespace interleaf
