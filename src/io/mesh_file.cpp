#include "io/mesh_file.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <stb_image_write.h>

#include "hierarchy/error.h"
#include "io/input_file.h"
#include "io/obj_lines.h"
#include "io/ply_properties.h"

namespace interleaf {

namespace {

constexpr std::uint64_t largest_obj = std::uint64_t{1} << 30;

ObjLines read_lines(const std::filesystem::path& file) {
    return read_obj_lines(read_text(file, largest_obj), file.string());
}

/// The vertices that triangles use, in their order.
std::vector<Index> used_vertices(const std::vector<Triangle>& triangles, std::size_t vertex_count) {
    std::vector<bool> is_used(vertex_count, false);
    for (const Triangle& triangle : triangles)
        for (const Index vertex : triangle) is_used[vertex] = true;
    std::vector<Index> used;
    for (Index vertex = 0; vertex < vertex_count; ++vertex)
        if (is_used[vertex]) used.push_back(vertex);
    return used;
}

/// Gives the vertices of \p triangles the numbers that they have in \p used.
void renumber(std::vector<Triangle>& triangles, const std::vector<Index>& used, std::size_t vertex_count) {
    std::vector<Index> number(vertex_count);
    for (Index n = 0; n < used.size(); ++n) number[used[n]] = n;
    for (Triangle& triangle : triangles)
        for (Index& vertex : triangle) vertex = number[vertex];
}

std::vector<glm::vec3> picked(const std::vector<glm::vec3>& values, const std::vector<Index>& used) {
    std::vector<glm::vec3> result;
    result.reserve(used.size());
    for (const Index vertex : used) result.push_back(values[vertex]);
    return result;
}

constexpr std::string_view color_name = "color";

Field color_field(std::span<const glm::vec3> colors) {
    Field field{std::string(color_name), FieldKind::color, {}};
    field.values.reserve(3 * colors.size());
    for (const glm::vec3& color : colors)
        field.values.insert(field.values.end(), {color.r, color.g, color.b});
    return field;
}

/// The vertices of \p lines that are \p used, over \p roots.
Hierarchy key_of(const RootComplex& roots, const ObjLines& lines, const std::vector<Index>& used) {
    Hierarchy key = unrefined(roots, picked(lines.positions, used));
    if (!lines.colors.empty()) key.fields.push_back(color_field(picked(lines.colors, used)));
    return key;
}

/// The roots that the faces of \p lines are; \p used gets the vertices that they use.
RootComplex roots_of(const ObjLines& lines, const std::string& name, std::vector<Index>& used) {
    std::vector<Triangle> triangles = triangles_of(lines, name);
    used = used_vertices(triangles, lines.positions.size());
    renumber(triangles, used, lines.positions.size());
    try {
        return {static_cast<Index>(used.size()), std::move(triangles)};
    } catch (const InputError& error) {
        throw InputError(
            fmt::format("{}: faces, as triangles (these and the vertices in use counted from 0): {}", name,
                        error.what()));
    }
}

/// "(1, 2, 3)", counted from 1 as in the file.
std::string corners_text(std::span<const Index> corners) {
    constexpr std::size_t most = 12;
    std::string text;
    for (const Index corner : corners.first(std::min(corners.size(), most)))
        text += fmt::format("{}{}", text.empty() ? "(" : ", ", corner + 1);
    return text + (corners.size() > most ? ", ...)" : ")");
}

/// Where the faces of \p lines differ from those of \p first, the file \p first_name; empty where they do
/// not.
std::string face_difference(const ObjLines& lines, const ObjLines& first, std::string_view first_name) {
    std::size_t corner = 0;
    for (std::size_t face = 0; face < std::min(lines.face_sizes.size(), first.face_sizes.size()); ++face) {
        const auto of = [&](const ObjLines& some) {
            return std::span(some.corners).subspan(corner, some.face_sizes[face]);
        };
        if (!std::ranges::equal(of(lines), of(first)))
            return fmt::format("face {}: has the vertices {}, expected {} as in {} (counted from 1)",
                               face + 1, corners_text(of(lines)), corners_text(of(first)), first_name);
        corner += lines.face_sizes[face];
    }
    if (lines.face_sizes.size() > first.face_sizes.size())
        return fmt::format("face {}: expected {} faces, as {} has", first.face_sizes.size() + 1,
                           first.face_sizes.size(), first_name);
    if (lines.face_sizes.size() < first.face_sizes.size())
        return fmt::format("has {} faces, expected more, as {} has", lines.face_sizes.size(), first_name);
    return "";
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
    const ObjLines lines = read_lines(file);
    std::vector<Index> used;
    const RootComplex roots = roots_of(lines, file.string(), used);
    return key_of(roots, lines, used);
}

std::vector<Hierarchy> read_obj_series(std::span<const std::filesystem::path> files) {
    std::vector<Hierarchy> series;
    if (files.empty()) return series;
    series.reserve(files.size());
    const std::string first_name = files.front().string();
    const ObjLines first = read_lines(files.front());
    std::vector<Index> used;
    const RootComplex roots = roots_of(first, first_name, used);
    series.push_back(key_of(roots, first, used));
    for (const std::filesystem::path& file : files.subspan(1)) {
        const ObjLines lines = read_lines(file);
        const std::string difference = face_difference(lines, first, first_name);
        if (!difference.empty()) throw InputError(fmt::format("{}: {}", file.string(), difference));
        series.push_back(key_of(roots, lines, used));
    }
    return series;
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
