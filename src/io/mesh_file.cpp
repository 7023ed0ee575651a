#include "io/mesh_file.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <stb_image_write.h>
#include <tiny_obj_loader.h>

#include "hierarchy/error.h"
#include "io/input_file.h"
#include "io/obj_lines.h"
#include "io/ply_properties.h"

namespace interleaf {

namespace {

constexpr std::uint64_t largest_obj = std::uint64_t{1} << 30;

/// The faces as triangles, polygons divided by tinyobjloader.
std::vector<Triangle> triangulated(const ObjLines& lines, std::string_view name) {
    tinyobj::ObjReader reader;
    tinyobj::ObjReaderConfig options;
    options.vertex_color = false;
    if (!reader.ParseFromString(lines.text, "", options))
        throw InputError(fmt::format("{}: {}", name, reader.Error()));

    std::vector<Triangle> triangles;
    triangles.reserve(lines.triangle_count);
    for (const tinyobj::shape_t& shape : reader.GetShapes())
        for (std::size_t i = 0; i < shape.mesh.indices.size(); i += 3) {
            const auto vertex = [&](std::size_t corner) {
                return static_cast<Index>(shape.mesh.indices[i + corner].vertex_index);
            };
            triangles.push_back({vertex(0), vertex(1), vertex(2)});
        }
    if (triangles.size() != lines.triangle_count)
        throw InputError(fmt::format("{}: faces: a polygon cannot be divided into triangles", name));
    return triangles;
}

/// Drops the vertices that no triangle uses; the others keep their order.
void drop_unused(std::vector<Triangle>& triangles, std::vector<glm::vec3>& positions,
                 std::vector<glm::vec3>& colors) {
    std::vector<bool> used(positions.size(), false);
    for (const Triangle& triangle : triangles)
        for (const Index vertex : triangle) used[vertex] = true;

    std::vector<Index> new_index(positions.size());
    Index count = 0;
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex)
        if (used[vertex]) {
            positions[count] = positions[vertex];
            if (!colors.empty()) colors[count] = colors[vertex];
            new_index[vertex] = count++;
        }
    positions.resize(count);
    if (!colors.empty()) colors.resize(count);
    for (Triangle& triangle : triangles)
        for (Index& vertex : triangle) vertex = new_index[vertex];
}

constexpr std::string_view color_name = "color";

Field color_field(std::span<const glm::vec3> colors) {
    Field field{std::string(color_name), FieldKind::color, {}};
    field.values.reserve(3 * colors.size());
    for (const glm::vec3& color : colors)
        field.values.insert(field.values.end(), {color.r, color.g, color.b});
    return field;
}

/// The colours that formats with one colour a vertex get; null when there are none.
const Field* vertex_colors(std::span<const Field> fields) {
    if (const Field* named = find_field(fields, {std::string(color_name), FieldKind::color})) return named;
    const auto found = std::ranges::find(fields, FieldKind::color, &Field::kind);
    return found == fields.end() ? nullptr : &*found;
}

void append_bytes(std::string& bytes, const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
}

}  // namespace

Hierarchy read_obj(const std::filesystem::path& file) {
    const std::string name = file.string();
    ObjLines lines = read_obj_lines(read_text(file, largest_obj), name);
    std::vector<Triangle> triangles = triangulated(lines, name);
    drop_unused(triangles, lines.positions, lines.colors);
    try {
        const auto vertex_count = static_cast<Index>(lines.positions.size());
        Hierarchy hierarchy = unrefined(RootComplex(vertex_count, std::move(triangles)), lines.positions);
        if (!lines.colors.empty()) hierarchy.fields.push_back(color_field(lines.colors));
        return hierarchy;
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: faces (counted from 0, as triangles): {}", name, error.what()));
    }
}

std::string obj_text(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                     std::span<const Field> fields) {
    std::string text;
    const Field* const colors = vertex_colors(fields);
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const glm::vec3& p = positions[v];
        fmt::format_to(std::back_inserter(text), "v {} {} {}", p.x, p.y, p.z);
        if (colors != nullptr)
            for (const float part : colors->at(static_cast<Index>(v)))
                fmt::format_to(std::back_inserter(text), " {}", part);
        text += '\n';
    }
    for (const auto& [i, j, k] : triangles)
        fmt::format_to(std::back_inserter(text), "f {} {} {}\n", i + 1, j + 1, k + 1);
    return text;
}

std::string ply_bytes(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                      std::span<const Field> fields) {
    const std::vector<PlyProperty> properties = ply_properties(fields, vertex_colors(fields));
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\n"
        "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n",
        positions.size());
    for (const PlyProperty& property : properties)
        bytes += fmt::format("property {} {}\n", property.is_byte ? "uchar" : "float", property.name);
    bytes += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                         triangles.size());
    bytes.reserve(bytes.size() + positions.size() * (sizeof(glm::vec3) + sizeof(float) * properties.size()) +
                  triangles.size_bytes() + triangles.size());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        append_bytes(bytes, &positions[v], sizeof(glm::vec3));
        for (const PlyProperty& property : properties) {
            const float value = property.field->at(static_cast<Index>(v))[property.component];
            if (property.is_byte)
                bytes += static_cast<char>(std::lround(255 * value));
            else
                append_bytes(bytes, &value, sizeof(value));
        }
    }
    for (const Triangle& triangle : triangles) {
        bytes += '\x03';
        append_bytes(bytes, triangle.data(), sizeof(Triangle));
    }
    return bytes;
}

std::string png_bytes(std::span<const std::uint8_t> rgba, int width, int height) {
    assert(width > 0 && height > 0);
    assert(rgba.size() == std::size_t{4} * static_cast<unsigned>(width) * static_cast<unsigned>(height));
    std::string bytes;
    const auto append = [](void* target, void* data, int size) {
        append_bytes(*static_cast<std::string*>(target), data, static_cast<std::size_t>(size));
    };
    if (stbi_write_png_to_func(append, &bytes, width, height, 4, rgba.data(), 4 * width) == 0)
        throw MachineError("not enough memory to compress the picture");
    return bytes;
}

}  // namespace interleaf
