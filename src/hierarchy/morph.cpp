#include "hierarchy/morph.h"

#include <algorithm>
#include <array>
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

namespace {

using Streams = std::span<const Buffer<glm::vec3>>;

/// sum[n] = sum over s < count of weights[s] * streams[s][n], added to \p sum[n] unless \p is_first, over
/// single floats.
template <std::size_t count>
void add_streams(Streams streams, std::span<const float> weights, bool is_first, std::span<float> sum) {
    std::array<const float*, count> from;
    std::array<float, count> factor;
    for (std::size_t s = 0; s < count; ++s) {
        from[s] = &streams[s].data()->x;
        factor[s] = weights[s];
    }
    float* const __restrict to = sum.data();
    const auto blended = [&](std::size_t n) {
        float value = factor[0] * from[0][n];
        for (std::size_t s = 1; s < count; ++s) value += factor[s] * from[s][n];
        return value;
    };
    if (is_first)
        for (std::size_t n = 0; n < sum.size(); ++n) to[n] = blended(n);
    else
        for (std::size_t n = 0; n < sum.size(); ++n) to[n] += blended(n);
}

}  // namespace

void weighted_sum(Streams streams, std::span<const float> weights, std::vector<glm::vec3>& sum) {
    sum.resize(streams[0].size());
    const std::span<float> floats(sum.empty() ? nullptr : &sum.data()->x, 3 * sum.size());
    // Memory is the limit: as many streams as are usually active are read in one pass.
    for (std::size_t s = 0; s < streams.size();) {
        const bool is_first = s == 0;
        switch (streams.size() - s) {
            case 1:
                add_streams<1>(streams.subspan(s), weights.subspan(s), is_first, floats);
                break;
            case 2:
                add_streams<2>(streams.subspan(s), weights.subspan(s), is_first, floats);
                break;
            case 3:
                add_streams<3>(streams.subspan(s), weights.subspan(s), is_first, floats);
                break;
            default:
                add_streams<4>(streams.subspan(s), weights.subspan(s), is_first, floats);
        }
        s += std::min<std::size_t>(streams.size() - s, 4);
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
