#include "hierarchy/morph.h"

#include <algorithm>
#include <cassert>

namespace interleaf {

std::vector<glm::vec3> morph(const UnionMesh& mesh, std::span<const float> weights) {
    std::vector<glm::vec3> positions;
    morph(mesh, weights, positions);
    return positions;
}

void morph(const UnionMesh& mesh, std::span<const float> weights, std::vector<glm::vec3>& positions) {
    assert(weights.size() == mesh.key_count());
    weighted_sum(mesh.positions, weights, positions);
}

void weighted_sum(std::span<const Buffer<glm::vec3>> streams, std::span<const float> weights,
                  std::vector<glm::vec3>& sum) {
    constexpr std::size_t block = 2048;  // vertices whose sum stays in the first-level cache
    const std::size_t count = streams[0].size();
    sum.resize(count);
    for (std::size_t begin = 0; begin < count; begin += block) {
        const std::size_t end = std::min(begin + block, count);
        for (std::size_t v = begin; v < end; ++v) sum[v] = weights[0] * streams[0][v];
        for (std::size_t s = 1; s < streams.size(); ++s)
            for (std::size_t v = begin; v < end; ++v) sum[v] += weights[s] * streams[s][v];
    }
}

Hierarchy morphed_hierarchy(const UnionMesh& mesh, std::span<const float> weights) {
    std::vector<Leaf> leaves;
    leaves.reserve(mesh.leaf_count());
    for (std::size_t t = 0; t < mesh.leaf_count(); ++t)
        leaves.push_back({mesh.triangles[t], static_cast<std::uint8_t>(mesh.tags[t].level())});
    return hierarchy_from_leaves(mesh.roots, leaves, morph(mesh, weights));
}

}  // namespace interleaf
