#include "hierarchy/union_fields.h"

#include <algorithm>
#include <cassert>

#include "hierarchy/color.h"

namespace interleaf {

namespace {

using Values = std::span<const float>;

/// The values of one key at the vertices of the union. The key's own vertices come in the order of their
/// numbers, because both number them by first visit. Ends of edges come before midpoints.
template <std::size_t width>
Buffer<float> stream_of(Values values, std::span<const Index> own_vertices,
                        std::span<const VertexOrigin> vertices) {
    Buffer<float> stream;
    stream.resize(width * vertices.size());
    std::size_t own = 0;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        float* const target = &stream[width * v];
        if (own < own_vertices.size() && own_vertices[own] == v) {
            std::copy_n(&values[width * own++], width, target);
            continue;
        }
        const auto [a, b] = vertices[v].edge;
        for (std::size_t c = 0; c < width; ++c)
            target[c] = (stream[width * a + c] + stream[width * b + c]) * 0.5F;
    }
    assert(own == own_vertices.size());
    return stream;
}

Buffer<float> light_of(Values colors) {
    Buffer<float> light;
    light.reserve(colors.size());
    for (std::size_t n = 0; n < colors.size(); n += 3) {
        const glm::vec3 at = linear_light({colors[n], colors[n + 1], colors[n + 2]});
        light.insert(light.end(), {at.r, at.g, at.b});
    }
    return light;
}

}  // namespace

std::vector<FieldName> common_fields(std::span<const Hierarchy* const> keys) {
    std::vector<FieldName> common;
    for (const Field& field : keys[0]->fields) {
        const FieldName label = field.label();
        const auto has_it = [&](const Hierarchy* key) { return find_field(key->fields, label) != nullptr; };
        if (std::ranges::all_of(keys, has_it)) common.push_back(label);
    }
    return common;
}

UnionField united_field(std::span<const Hierarchy* const> keys, const UnionMesh& mesh,
                        const FieldName& label) {
    assert(keys.size() == mesh.key_count());
    UnionField united{label, {}};
    for (std::size_t key = 0; key < keys.size(); ++key) {
        const Field* const field = find_field(keys[key]->fields, label);
        assert(field != nullptr);
        const Buffer<Index>& own = mesh.own_vertices[key];
        united.values.push_back(label.kind == FieldKind::scalar
                                    ? stream_of<1>(field->values, own, mesh.vertices)
                                    : stream_of<3>(light_of(field->values), own, mesh.vertices));
    }
    return united;
}

void unite_fields(std::span<const Hierarchy* const> keys, UnionMesh& mesh) {
    mesh.fields.clear();
    for (const FieldName& label : common_fields(keys)) mesh.fields.push_back(united_field(keys, mesh, label));
}

}  // namespace interleaf
