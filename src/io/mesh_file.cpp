#include "io/mesh_file.h"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <stb_image_write.h>
#include <tiny_obj_loader.h>

#include "hierarchy/error.h"
#include "io/input_file.h"
#include "io/obj_lines.h"

namespace interleaf {

namespace {

constexpr std::uint64_t largest_obj = std::uint64_t{1} << 30;

/// The faces as triangles, polygons divided by tinyobjloader.
std::vector<Triangle> triangulated(const ObjLines& lines, std::string_view name) {
    std::string text;
    for (const glm::vec3& p : lines.positions)
        fmt::format_to(std::back_inserter(text), "v {} {} {}\n", p.x, p.y, p.z);
    text += lines.faces;
    tinyobj::ObjReader reader;
    tinyobj::ObjReaderConfig options;
    options.vertex_color = false;
    if (!reader.ParseFromString(text, "", options))
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

/// The triangles in the numbers that their vertices have in \p used.
std::vector<Triangle> renumbered(std::vector<Triangle> triangles, const std::vector<Index>& used,
                                 std::size_t vertex_count) {
    std::vector<Index> number(vertex_count);
    for (Index n = 0; n < used.size(); ++n) number[used[n]] = n;
    for (Triangle& triangle : triangles)
        for (Index& vertex : triangle) vertex = number[vertex];
    return triangles;
}

std::vector<glm::vec3> picked(const std::vector<glm::vec3>& positions, const std::vector<Index>& used) {
    std::vector<glm::vec3> result;
    result.reserve(used.size());
    for (const Index vertex : used) result.push_back(positions[vertex]);
    return result;
}

/// The first of several OBJ files with the same faces, and what the others take from it.
struct ObjModel {
    std::string name;
    std::string faces;
    std::vector<Index> used;
    Hierarchy hierarchy;
};

ObjModel read_model(const std::filesystem::path& file) {
    ObjModel model;
    model.name = file.string();
    ObjLines lines = read_obj_lines(read_text(file, largest_obj), model.name);
    const std::vector<Triangle> triangles = triangulated(lines, model.name);
    const std::size_t vertex_count = lines.positions.size();
    model.used = used_vertices(triangles, vertex_count);
    try {
        const auto used_count = static_cast<Index>(model.used.size());
        model.hierarchy = unrefined(RootComplex(used_count, renumbered(triangles, model.used, vertex_count)),
                                    picked(lines.positions, model.used));
    } catch (const InputError& error) {
        throw InputError(
            fmt::format("{}: faces (counted from 0, as triangles): {}", model.name, error.what()));
    }
    model.faces = std::move(lines.faces);
    return model;
}

/// "f 1 2 3" as "(1, 2, 3)".
std::string corners_text(std::string_view line) {
    constexpr std::size_t longest = 60;
    std::string text = "(";
    for (const char c : line.substr(std::min<std::size_t>(line.size(), 2), longest))
        text += c == ' ' ? std::string(", ") : std::string(1, c);
    return text + (line.size() > longest + 2 ? "...)" : ")");
}

/// Where \p faces differ from those of \p model, which they do.
std::string first_difference(std::string_view faces, const ObjModel& model) {
    std::string_view expected = model.faces;
    for (std::size_t face = 1;; ++face) {
        const std::string_view line = faces.substr(0, faces.find('\n'));
        const std::string_view expected_line = expected.substr(0, expected.find('\n'));
        if (expected.empty())
            return fmt::format("face {}: expected {} faces, as {} has", face, face - 1, model.name);
        if (faces.empty()) return fmt::format("has {} faces, expected more, as {} has", face - 1, model.name);
        if (line != expected_line)
            return fmt::format("face {}: has the vertices {}, expected {} as in {} (counted from 1)", face,
                               corners_text(line), corners_text(expected_line), model.name);
        faces.remove_prefix(line.size() + 1);
        expected.remove_prefix(expected_line.size() + 1);
    }
}

void append_bytes(std::string& bytes, const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
}

}  // namespace

Hierarchy read_obj(const std::filesystem::path& file) {
    return read_model(file).hierarchy;
}

std::vector<Hierarchy> read_obj_series(std::span<const std::filesystem::path> files) {
    std::vector<Hierarchy> series;
    if (files.empty()) return series;
    series.reserve(files.size());
    const ObjModel model = read_model(files.front());
    series.push_back(model.hierarchy);
    for (const std::filesystem::path& file : files.subspan(1)) {
        const std::string name = file.string();
        const ObjLines lines = read_obj_lines(read_text(file, largest_obj), name);
        if (lines.faces != model.faces)
            throw InputError(fmt::format("{}: {}", name, first_difference(lines.faces, model)));
        series.push_back(unrefined(model.hierarchy.roots, picked(lines.positions, model.used)));
    }
    return series;
}

std::string obj_text(std::span<const Triangle> triangles, std::span<const glm::vec3> positions) {
    std::string text;
    for (const glm::vec3& p : positions)
        fmt::format_to(std::back_inserter(text), "v {} {} {}\n", p.x, p.y, p.z);
    for (const auto& [i, j, k] : triangles)
        fmt::format_to(std::back_inserter(text), "f {} {} {}\n", i + 1, j + 1, k + 1);
    return text;
}

std::string ply_bytes(std::span<const Triangle> triangles, std::span<const glm::vec3> positions) {
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\n"
        "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        positions.size(), triangles.size());
    bytes.reserve(bytes.size() + positions.size_bytes() + triangles.size_bytes() + triangles.size());
    append_bytes(bytes, positions.data(), positions.size_bytes());
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
