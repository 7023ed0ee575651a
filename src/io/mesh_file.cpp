#include "io/mesh_file.h"

#include <cassert>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <stb_image_write.h>

#include "hierarchy/error.h"
#include "io/input_file.h"
#include "io/obj_lines.h"

namespace interleaf {

namespace {

constexpr std::uint64_t largest_obj = std::uint64_t{1} << 30;

/// Drops the vertices that no triangle uses; the others keep their order.
void drop_unused(std::vector<Triangle>& triangles, std::vector<glm::vec3>& positions) {
    std::vector<bool> used(positions.size(), false);
    for (const Triangle& triangle : triangles)
        for (const Index vertex : triangle) used[vertex] = true;

    std::vector<Index> new_index(positions.size());
    Index count = 0;
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex)
        if (used[vertex]) {
            positions[count] = positions[vertex];
            new_index[vertex] = count++;
        }
    positions.resize(count);
    for (Triangle& triangle : triangles)
        for (Index& vertex : triangle) vertex = new_index[vertex];
}

void append_bytes(std::string& bytes, const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
}

}  // namespace

Hierarchy read_obj(const std::filesystem::path& file) {
    const std::string name = file.string();
    ObjLines lines = read_obj_lines(read_text(file, largest_obj), name);
    std::vector<Triangle> triangles = triangles_of(lines, name);
    drop_unused(triangles, lines.positions);
    try {
        const auto vertex_count = static_cast<Index>(lines.positions.size());
        return unrefined(RootComplex(vertex_count, std::move(triangles)), lines.positions);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: faces (counted from 0, as triangles): {}", name, error.what()));
    }
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
