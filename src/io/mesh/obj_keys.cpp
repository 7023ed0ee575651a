#include "io/mesh/obj_keys.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "family/origin.h"
#include "hierarchy/error.h"
#include "io/file/input_file.h"
#include "io/mesh/obj_lines.h"
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

Field color_field(const std::vector<glm::vec3>& colors, const std::vector<Index>& used) {
    Field field{"color", FieldKind::color, {}};
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

}  // namespace interleaf
