#include "io/mesh/mesh_file.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <stb_image_write.h>

#include "family/origin.h"
#include "hierarchy/error.h"
#include "io/file/input_file.h"
#include "io/mesh/obj_lines.h"
#include "io/mesh/ply_properties.h"
#include "io/mesh/polygon_mesh.h"

namespace interleaf {

namespace {

constexpr std::uint64_t max_obj_size = std::uint64_t{1} << 30;

PolygonMesh read_lines(const std::filesystem::path& file, std::vector<std::string>& remarks) {
    const std::string name = file.string();
    PolygonMesh mesh = read_obj_lines(read_text(file, max_obj_size), name);
    settle(mesh, name);
    for (const std::string& remark : mesh.remarks) remarks.push_back(fmt::format("{}: {}", name, remark));
    return mesh;
}

/// The vertices that triangles use, in ascending order.
std::vector<Index> used_vertices(const std::vector<Triangle>& triangles, std::size_t vertex_count) {
    std::vector<bool> is_used(vertex_count, false);
    for (const Triangle& triangle : triangles)
        for (const Index vertex : triangle) is_used[vertex] = true;
    std::vector<Index> used;
    for (Index vertex = 0; vertex < vertex_count; ++vertex)
        if (is_used[vertex]) used.push_back(vertex);
    return used;
}

/// Replaces each vertex of \p triangles by its number in \p used.
void renumber(std::vector<Triangle>& triangles, const std::vector<Index>& used, std::size_t vertex_count) {
    std::vector<Index> number(vertex_count);
    for (Index n = 0; n < used.size(); ++n) number[used[n]] = n;
    for (Triangle& triangle : triangles)
        for (Index& vertex : triangle) vertex = number[vertex];
}

constexpr std::string_view color_name = "color";

Field color_field(const std::vector<glm::vec3>& colors, const std::vector<Index>& used) {
    Field field{std::string(color_name), FieldKind::color, {}};
    field.values.reserve(3 * used.size());
    for (const Index vertex : used)
        field.values.insert(field.values.end(), {colors[vertex].r, colors[vertex].g, colors[vertex].b});
    return field;
}

/// The key over \p roots whose positions are those of the \p used vertices of \p lines, minus \p origin.
std::variant<Hierarchy, Misfit> key_of(const RootComplex& roots, const PolygonMesh& lines,
                                       const std::vector<Index>& used, const glm::dvec3& origin,
                                       const std::string& name) {
    std::vector<glm::vec3> positions;
    positions.reserve(used.size());
    for (const Index vertex : used) {
        const glm::dvec3 local = lines.positions[vertex] - origin;
        if (!is_place(local))
            return Misfit{
                fmt::format("{}: vertex {} (counted from 1): is too far from the origin, ({}, {}, {})", name,
                            vertex + 1, origin.x, origin.y, origin.z)};
        positions.emplace_back(local);
    }
    Hierarchy key = unrefined(roots, positions);
    if (!lines.colors.empty()) key.fields.push_back(color_field(lines.colors, used));
    return key;
}

/// The face that contains \p triangle.
std::size_t face_of_triangle(const PolygonMesh& mesh, std::size_t triangle) {
    std::size_t face = 0;
    for (std::size_t end = mesh.face_sizes[0] - 2; end <= triangle; end += mesh.face_sizes[face] - 2) ++face;
    return face;
}

/// The roots made of \p triangles, which are the faces of \p lines.
/// \param used  the vertices that they use
std::variant<RootComplex, Misfit> roots_of(std::vector<Triangle> triangles, const PolygonMesh& lines,
                                           const std::vector<Index>& used, const std::string& name) {
    renumber(triangles, used, lines.positions.size());
    try {
        return RootComplex(static_cast<Index>(used.size()), std::move(triangles));
    } catch (const RootError& error) {
        return Misfit{
            fmt::format("{}: faces, as triangles (these and the vertices in use counted from 0): {} ({})",
                        name, error.what(), place_of_face(lines, face_of_triangle(lines, error.triangle)))};
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

/// Says where the faces of \p lines differ from those of \p first, which was read from \p first_name; empty
/// if they do not differ.
std::string face_difference(const PolygonMesh& lines, const PolygonMesh& first, std::string_view first_name) {
    std::size_t corner = 0;
    for (std::size_t face = 0; face < std::min(lines.face_sizes.size(), first.face_sizes.size()); ++face) {
        const auto of = [&](const PolygonMesh& some) {
            return std::span(some.corners).subspan(corner, some.face_sizes[face]);
        };
        if (!std::ranges::equal(of(lines), of(first)))
            return fmt::format("line {}: a face of the vertices {}, expected {} as in line {} of {}",
                               lines.face_lines[face], corners_text(of(lines)), corners_text(of(first)),
                               first.face_lines[face], first_name);
        corner += lines.face_sizes[face];
    }
    if (lines.face_sizes.size() != first.face_sizes.size())
        return fmt::format("has {} faces, expected {} as in {}", lines.face_sizes.size(),
                           first.face_sizes.size(), first_name);
    return "";
}

/// The color field for formats with one color per vertex; null if there is none.
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
    return std::move(read_obj_series(std::span(&file, 1)).keys.front());
}

FileKeys read_obj_series(std::span<const std::filesystem::path> files, std::optional<glm::dvec3> origin) {
    auto read = read_obj_keys(files, origin);
    if (const auto* misfit = std::get_if<Misfit>(&read)) throw InputError(misfit->reason);
    return std::get<FileKeys>(std::move(read));
}

std::variant<FileKeys, Misfit> read_obj_keys(std::span<const std::filesystem::path> files,
                                             std::optional<glm::dvec3> origin) {
    FileKeys series;
    if (files.empty()) return series;
    series.keys.reserve(files.size());
    const std::string first_name = files.front().string();
    const PolygonMesh first = read_lines(files.front(), series.remarks);
    std::vector<Triangle> triangles = triangles_of(first, first_name);
    series.origin = origin ? *origin : origin_for(first.positions, triangles);
    const std::vector<Index> used = used_vertices(triangles, first.positions.size());
    auto roots = roots_of(std::move(triangles), first, used, first_name);
    if (auto* misfit = std::get_if<Misfit>(&roots)) return std::move(*misfit);
    for (const std::filesystem::path& file : files) {
        const bool is_first = series.keys.empty();
        const PolygonMesh lines = is_first ? PolygonMesh() : read_lines(file, series.remarks);
        if (const std::string difference = is_first ? "" : face_difference(lines, first, first_name);
            !difference.empty())
            return Misfit{fmt::format("{}: {}; `interleaf fit` makes keys of meshes with different faces",
                                      file.string(), difference)};
        auto key = key_of(std::get<RootComplex>(roots), is_first ? first : lines, used, *series.origin,
                          file.string());
        if (auto* misfit = std::get_if<Misfit>(&key)) return std::move(*misfit);
        series.keys.push_back(std::get<Hierarchy>(std::move(key)));
    }
    return series;
}

std::string obj_text(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                     std::span<const Field> fields, const glm::dvec3& origin) {
    std::string text;
    const Field* const colors = vertex_colors(fields);
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const glm::vec3& local = positions[v];
        if (const glm::dvec3 p = glm::dvec3(local) + origin; origin != glm::dvec3(0))
            fmt::format_to(std::back_inserter(text), "v {} {} {}", p.x, p.y, p.z);
        else
            fmt::format_to(std::back_inserter(text), "v {} {} {}", local.x, local.y, local.z);
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
                      std::span<const Field> fields, const glm::dvec3& origin,
                      std::span<const FieldScale> scales) {
    const bool is_local = origin == glm::dvec3(0);
    const std::vector<PlyProperty> properties = ply_properties(fields, vertex_colors(fields), scales);
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\n"
        "element vertex {0}\nproperty {1} x\nproperty {1} y\nproperty {1} z\n",
        positions.size(), is_local ? "float" : "double");
    for (const PlyProperty& property : properties)
        bytes += fmt::format("property {} {}\n", property.type(), property.name);
    bytes += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                         triangles.size());
    bytes.reserve(bytes.size() +
                  positions.size() * (sizeof(glm::dvec3) + sizeof(double) * properties.size()) +
                  triangles.size_bytes() + triangles.size());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const glm::dvec3 placed = glm::dvec3(positions[v]) + origin;
        if (is_local)
            append_bytes(bytes, &positions[v], sizeof(glm::vec3));
        else
            append_bytes(bytes, &placed, sizeof(placed));
        for (const PlyProperty& property : properties) {
            const float value = property.field->at(static_cast<Index>(v))[property.component];
            if (property.is_byte)
                bytes += static_cast<char>(std::lround(255 * value));
            else if (const double sum = double{value} + property.offset; property.offset != 0)
                append_bytes(bytes, &sum, sizeof(sum));
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
