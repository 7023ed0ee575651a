#include "io/gltf/gltf_mesh.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <fmt/core.h>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "io/gltf/gltf_constants.h"
#include "io/mesh/polygon_mesh.h"

namespace interleaf {

namespace {

enum Mode : std::uint32_t { triangle_list = 4, triangle_strip = 5, triangle_fan = 6, mode_count = 7 };

constexpr std::string_view out_of_range = "is put beyond the range of floats by its node";

/// A primitive that holds triangles, and where it is.
struct Primitive {
    JsonPlace place;
    std::uint32_t mode;
    glm::dmat4 matrix;
};

std::vector<Primitive> primitives_of(const GltfFile& file, std::span<const MeshInstance> instances,
                                     std::vector<std::string>& remarks) {
    std::vector<Primitive> found;
    std::size_t others = 0;
    for (const auto& [mesh, matrix] : instances) {
        const JsonPlace primitives = file.element("meshes", mesh).member("primitives");
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const JsonPlace primitive = primitives.element(i);
            const auto given = primitive.optional_member("mode");
            const std::uint32_t mode = given ? given->index_below(mode_count) : triangle_list;
            if (mode < triangle_list)
                ++others;
            else
                found.push_back({primitive, mode, matrix});
        }
    }
    if (others > 0)
        remarks.push_back(fmt::format("{} primitives of points or lines were passed over.", others));
    if (found.empty()) file.root().fail("has no triangles in its scene");
    return found;
}

std::optional<FieldKind> kind_of(std::string_view attribute) {
    if (attribute.starts_with("COLOR_")) return FieldKind::color;
    if (attribute.starts_with("_")) return FieldKind::scalar;
    return std::nullopt;
}

/// The attributes that are fields, and that all of \p primitives have.
std::vector<GltfAttribute> common_attributes(std::span<const Primitive> primitives) {
    std::map<std::string, std::size_t> counts;
    for (const Primitive& primitive : primitives)
        for (const std::string& name : primitive.place.member("attributes").member_names()) ++counts[name];
    std::vector<GltfAttribute> common;
    for (const auto& [name, count] : counts)
        if (const auto kind = kind_of(name);
            kind && count == primitives.size() && common.size() < max_field_count)
            common.push_back({name, *kind, {}, {}});
    return common;
}

std::vector<glm::vec3> vectors_at(GltfArrays& arrays, const JsonPlace& place) {
    const GltfArray array = arrays.numbers(place);
    if (array.width != 3) place.fail_expecting("the number of an accessor of type VEC3");
    std::vector<glm::vec3> vectors;
    vectors.reserve(array.count());
    for (std::size_t n = 0; n < array.values.size(); n += 3)
        vectors.emplace_back(array.values[n], array.values[n + 1], array.values[n + 2]);
    return vectors;
}

void check_count(const JsonPlace& place, std::size_t count, std::size_t expected) {
    if (count != expected)
        place.fail(fmt::format("has {} elements, expected {}, one per vertex", count, expected));
}

/// Appends the triangles of the corners \p corner(0) to \p corner(count - 1), each \p first higher.
void append_triangles(const Primitive& primitive, const std::vector<Index>& corners, Index first,
                      std::vector<Triangle>& triangles) {
    const bool is_mirrored = glm::determinant(glm::dmat3(primitive.matrix)) < 0;
    const auto add = [&](Index a, Index b, Index c) {
        if (is_mirrored) std::swap(b, c);
        triangles.push_back({first + a, first + b, first + c});
    };
    if (primitive.mode == triangle_list) {
        if (corners.size() % 3 != 0)
            primitive.place.fail(fmt::format("has {} corners, expected three per triangle", corners.size()));
        for (std::size_t n = 0; n < corners.size(); n += 3) add(corners[n], corners[n + 1], corners[n + 2]);
        return;
    }
    for (std::size_t n = 0; n + 2 < corners.size(); ++n) {
        if (primitive.mode == triangle_fan)
            add(corners[n + 1], corners[n + 2], corners[0]);
        else
            add(corners[n], corners[n + 1 + n % 2], corners[n + 2 - n % 2]);
    }
}

std::vector<Index> corners_of(const Primitive& primitive, GltfArrays& arrays, std::size_t vertex_count) {
    if (const auto indices = primitive.place.optional_member("indices"))
        return arrays.indices(*indices, vertex_count);
    std::vector<Index> corners(vertex_count);
    for (std::size_t v = 0; v < vertex_count; ++v) corners[v] = static_cast<Index>(v);
    return corners;
}

/// Appends the values of an attribute, without alpha.
void append_values(GltfArrays& arrays, const JsonPlace& place, FieldKind kind, std::size_t vertex_count,
                   std::vector<float>& values) {
    const GltfArray array = arrays.numbers(place);
    check_count(place, array.count(), vertex_count);
    const std::size_t width = component_count(kind);
    const bool has_alpha = kind == FieldKind::color && array.width == width + 1;
    if (array.width != width && !has_alpha)
        place.fail_expecting(fmt::format("the number of an accessor with {} numbers per element", width));
    for (std::size_t v = 0; v < vertex_count; ++v)
        for (std::size_t c = 0; c < width; ++c) values.push_back(array.values[v * array.width + c]);
}

/// Appends the targets of a primitive of \p vertex_count vertices.
void append_targets(const Primitive& primitive, GltfArrays& arrays, std::size_t vertex_count,
                    GltfMesh& mesh) {
    const auto targets = primitive.place.optional_member("targets");
    const std::size_t count = targets ? targets->size() : 0;
    if (count != mesh.deltas.size())
        primitive.place.fail(fmt::format("has {} morph targets, expected {} as the first primitive", count,
                                         mesh.deltas.size()));
    const glm::dmat3 linear(primitive.matrix);
    for (std::size_t t = 0; t < count; ++t) {
        const JsonPlace target = targets->element(t);
        if (const auto position = target.optional_member(gltf::position)) {
            const std::vector<glm::vec3> deltas = vectors_at(arrays, *position);
            check_count(*position, deltas.size(), vertex_count);
            for (const glm::vec3& delta : deltas) {
                const glm::dvec3 placed = linear * glm::dvec3(delta);
                if (!is_place(placed)) target.fail(out_of_range);
                mesh.deltas[t].emplace_back(placed);
            }
        } else {
            arrays.charge(target, 3 * vertex_count);
            mesh.deltas[t].resize(mesh.positions.size(), glm::vec3(0));
        }
        for (GltfAttribute& attribute : mesh.attributes) {
            if (const auto values = target.optional_member(attribute.name)) {
                append_values(arrays, *values, attribute.kind, vertex_count, attribute.deltas[t]);
            } else {
                arrays.charge(target, component_count(attribute.kind) * vertex_count);
                attribute.deltas[t].resize(attribute.values.size(), 0.0F);
            }
        }
    }
}

}  // namespace

std::size_t target_count(const GltfFile& file, std::size_t mesh) {
    const JsonPlace primitives = file.element("meshes", mesh).member("primitives");
    if (primitives.size() == 0) return 0;
    const auto targets = primitives.element(0).optional_member("targets");
    return targets ? targets->size() : 0;
}

GltfMesh read_meshes(const GltfFile& file, std::span<const MeshInstance> instances) {
    GltfArrays arrays(file);
    GltfMesh mesh;
    const std::vector<Primitive> primitives = primitives_of(file, instances, mesh.remarks);
    mesh.attributes = common_attributes(primitives);
    mesh.deltas.resize(instances.empty() ? 0 : target_count(file, instances.front().mesh));
    for (GltfAttribute& attribute : mesh.attributes) attribute.deltas.resize(mesh.deltas.size());
    for (const Primitive& primitive : primitives) {
        const JsonPlace attributes = primitive.place.member("attributes");
        const std::size_t first = mesh.positions.size();
        const std::vector<glm::vec3> positions = vectors_at(arrays, attributes.member(gltf::position));
        if (first + positions.size() >= no_index) file.root().fail("has more vertices than fit into 32 bits");
        for (const glm::vec3& position : positions) {
            mesh.positions.emplace_back(primitive.matrix * glm::dvec4(position, 1));
            if (!is_place(mesh.positions.back())) primitive.place.fail(out_of_range);
        }
        append_triangles(primitive, corners_of(primitive, arrays, positions.size()),
                         static_cast<Index>(first), mesh.triangles);
        for (GltfAttribute& attribute : mesh.attributes)
            append_values(arrays, attributes.member(attribute.name), attribute.kind, positions.size(),
                          attribute.values);
        append_targets(primitive, arrays, positions.size(), mesh);
    }
    return mesh;
}

}  // namespace interleaf
