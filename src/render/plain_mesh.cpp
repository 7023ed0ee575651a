#include "render/plain_mesh.h"

namespace interleaf {

UnionMesh plain_mesh(std::span<const Triangle> triangles, std::span<const glm::vec3> positions) {
    UnionMesh mesh;
    mesh.triangles.assign(triangles.begin(), triangles.end());
    mesh.tags.assign(triangles.size(), LeafTag(0, 0, {0, 0, 0}));
    mesh.origins.assign(triangles.size(), key_bit(0));
    mesh.vertices.assign(positions.size(), VertexOrigin{{no_index, no_index}, key_bit(0)});
    mesh.positions.emplace_back(positions.begin(), positions.end());
    return mesh;
}

}  // namespace interleaf
