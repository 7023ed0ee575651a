#include "hierarchy/morph.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include <glm/common.hpp>

#include "hierarchy/color.h"

namespace interleaf {

Buffer<glm::vec3> morph(const UnionMesh& mesh, std::span<const float> weights) {
    Buffer<glm::vec3> positions;
    morph(mesh, weights, positions);
    return positions;
}

void morph(const UnionMesh& mesh, std::span<const float> weights, Buffer<glm::vec3>& positions) {
    assert(weights.size() == mesh.key_count());
    if (mesh.turning)
        mesh.turning->blend(mesh, weights, positions);
    else
        weighted_sum(mesh.positions, weights, positions);
}

namespace {

using Streams = std::span<const float* const>;

/// Computes sum[n] = sum over s < count of weights[s] * streams[s][n], and adds it to \p sum[n] unless
/// \p is_first.
template <std::size_t count>
void add_streams(Streams streams, std::span<const float> weights, bool is_first, std::span<float> sum) {
    std::array<const float*, count> from;
    std::array<float, count> factor;
    for (std::size_t s = 0; s < count; ++s) {
        from[s] = streams[s];
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

/// The weighted sum of streams of single floats, each as long as \p sum.
void add_up(Streams streams, std::span<const float> weights, std::span<float> sum) {
    // Memory is the bottleneck, so one pass reads as many streams as are usually active.
    for (std::size_t s = 0; s < streams.size();) {
        const bool is_first = s == 0;
        switch (streams.size() - s) {
            case 1:
                add_streams<1>(streams.subspan(s), weights.subspan(s), is_first, sum);
                break;
            case 2:
                add_streams<2>(streams.subspan(s), weights.subspan(s), is_first, sum);
                break;
            case 3:
                add_streams<3>(streams.subspan(s), weights.subspan(s), is_first, sum);
                break;
            default:
                add_streams<4>(streams.subspan(s), weights.subspan(s), is_first, sum);
        }
        s += std::min<std::size_t>(streams.size() - s, 4);
    }
}

}  // namespace

void weighted_sum(std::span<const Buffer<glm::vec3>> streams, std::span<const float> weights,
                  Buffer<glm::vec3>& sum) {
    sum.resize(streams[0].size());
    if (sum.empty()) return;
    std::vector<const float*> floats;
    floats.reserve(streams.size());
    for (const Buffer<glm::vec3>& stream : streams) floats.push_back(&stream.data()->x);
    add_up(floats, weights, {&sum.data()->x, 3 * sum.size()});
}

void morph(const UnionField& field, std::span<const float> weights, Buffer<float>& values) {
    assert(weights.size() == field.values.size());
    values.resize(field.values[0].size());
    std::vector<const float*> streams;
    streams.reserve(field.values.size());
    for (const Buffer<float>& stream : field.values) streams.push_back(stream.data());
    add_up(streams, weights, values);
}

Field morphed_field(const UnionField& field, std::span<const float> weights) {
    Buffer<float> values;
    morph(field, weights, values);
    if (field.label.kind == FieldKind::color)
        for (std::size_t n = 0; n < values.size(); n += 3) {
            const glm::vec3 light(values[n], values[n + 1], values[n + 2]);
            const glm::vec3 color = encoded(glm::clamp(light, 0.0F, 1.0F));
            for (int c = 0; c < 3; ++c) values[n + static_cast<std::size_t>(c)] = color[c];
        }
    return {field.label.name, field.label.kind, std::move(values)};
}

Hierarchy morphed_hierarchy(const UnionMesh& mesh, std::span<const float> weights) {
    std::vector<Leaf> leaves;
    leaves.reserve(mesh.leaf_count());
    for (std::size_t t = 0; t < mesh.leaf_count(); ++t)
        leaves.push_back({mesh.triangles[t], static_cast<std::uint8_t>(mesh.tags[t].level())});
    std::vector<Field> fields;
    fields.reserve(mesh.fields.size());
    for (const UnionField& field : mesh.fields) fields.push_back(morphed_field(field, weights));
    return hierarchy_from_leaves(mesh.roots, leaves, morph(mesh, weights), fields);
}

}  // namespace interleaf
