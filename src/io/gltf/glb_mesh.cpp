#include "io/gltf/glb_mesh.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/gltf/gltf_constants.h"

namespace interleaf {

namespace {

using nlohmann::ordered_json;

/// Adds \p values, linear light or scalars, as an attribute.
std::size_t add_field(GlbBuilder& builder, FieldKind kind, std::span<const float> values) {
    if (kind == FieldKind::scalar) return builder.add_scalars(values);
    std::vector<glm::vec3> colors;
    colors.reserve(values.size() / 3);
    for (std::size_t n = 0; n < values.size(); n += 3)
        colors.emplace_back(values[n], values[n + 1], values[n + 2]);
    return builder.add_vectors(colors, GlbBounds::without);
}

std::vector<float> difference(std::span<const float> values, std::span<const float> base) {
    std::vector<float> deltas(values.size());
    for (std::size_t n = 0; n < deltas.size(); ++n) deltas[n] = values[n] - base[n];
    return deltas;
}

std::vector<glm::vec3> difference(std::span<const glm::vec3> values, std::span<const glm::vec3> base) {
    std::vector<glm::vec3> deltas(values.size());
    for (std::size_t n = 0; n < deltas.size(); ++n) deltas[n] = values[n] - base[n];
    return deltas;
}

/// The place of the field that is COLOR_0.
std::size_t first_color(std::span<const UnionField> fields) {
    const auto is_color = [](const UnionField& field) { return field.label.kind == FieldKind::color; };
    const auto named = std::ranges::find(fields, FieldName{"color", FieldKind::color}, &UnionField::label);
    const auto first = named == fields.end() ? std::ranges::find_if(fields, is_color) : named;
    return static_cast<std::size_t>(first - fields.begin());
}

/// "_HEIGHT" for the field "height".
std::string scalar_attribute(std::string_view name) {
    std::string attribute = "_";
    for (const char c : name) {
        const bool is_small = c >= 'a' && c <= 'z';
        const bool is_kept = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        attribute += is_small ? static_cast<char>(c - 'a' + 'A') : is_kept ? c : '_';
    }
    return attribute;
}

}  // namespace

std::vector<std::string> attribute_names(std::span<const UnionField> fields) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    const std::size_t first = first_color(fields);
    std::size_t color = 1;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (fields[i].label.kind == FieldKind::color) {
            names.push_back(i == first ? std::string(gltf::color) : fmt::format("COLOR_{}", color++));
            continue;
        }
        const std::string wanted = scalar_attribute(fields[i].label.name);
        std::string name = wanted;
        for (unsigned number = 2; !taken.insert(name).second; ++number)
            name = fmt::format("{}_{}", wanted, number);
        names.push_back(std::move(name));
    }
    return names;
}

std::uint64_t primitive_size(const UnionMesh& mesh) {
    std::uint64_t floats = 6;
    for (const UnionField& field : mesh.fields) floats += component_count(field.label.kind);
    const std::uint64_t index_size = mesh.vertex_count() > 0xffff ? 4 : 2;
    return sizeof(float) * floats * mesh.vertex_count() * mesh.key_count() +
           3 * index_size * mesh.leaf_count();
}

void require_primitive_size(const UnionMesh& mesh, std::uint64_t max_size) {
    if (const std::uint64_t size = primitive_size(mesh); size > max_size)
        throw InputError(fmt::format(
            "the union of all {} keys has {} vertices; as .glb it would take {} bytes, expected at most {}. "
            "--segments takes less for a long timeline",
            mesh.key_count(), mesh.vertex_count(), size, max_size));
}

ordered_json add_primitive(GlbBuilder& builder, const UnionMesh& mesh, std::size_t base,
                           std::span<const KeyPair> pairs, const Progress& progress) {
    const std::vector<std::string> names = attribute_names(mesh.fields);
    const TargetNormals normals = target_normals(mesh, base, pairs, progress);

    ordered_json attributes;
    attributes[gltf::position] = builder.add_vectors(mesh.positions[base], GlbBounds::with);
    attributes[gltf::normal] = builder.add_vectors(normals.base, GlbBounds::without);
    for (std::size_t i = 0; i < names.size(); ++i)
        attributes[names[i]] = add_field(builder, mesh.fields[i].label.kind, mesh.fields[i].values[base]);

    ordered_json targets = ordered_json::array();
    for (std::size_t key = 0; key < mesh.key_count(); ++key) {
        if (key == base) continue;
        ordered_json target;
        target[gltf::position] =
            builder.add_vectors(difference(mesh.positions[key], mesh.positions[base]), GlbBounds::with);
        target[gltf::normal] = builder.add_vectors(normals.deltas[key], GlbBounds::without);
        for (std::size_t i = 0; i < names.size(); ++i) {
            const auto& values = mesh.fields[i].values;
            target[names[i]] =
                add_field(builder, mesh.fields[i].label.kind, difference(values[key], values[base]));
        }
        targets.push_back(std::move(target));
    }

    ordered_json primitive = {{"attributes", std::move(attributes)}};
    primitive["indices"] = builder.add_indices(mesh.triangles, mesh.vertex_count());
    primitive["material"] = 0;
    if (!targets.empty()) primitive["targets"] = std::move(targets);
    return primitive;
}

}  // namespace interleaf
