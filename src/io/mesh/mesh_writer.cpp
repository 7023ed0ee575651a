#include "io/mesh/mesh_writer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "io/mesh/ply_properties.h"

namespace interleaf {

namespace {

/// The color field for formats with one color per vertex; null if there is none.
const Field* vertex_colors(std::span<const Field> fields) {
    if (const Field* named = find_field(fields, {"color", FieldKind::color})) return named;
    const auto found = std::ranges::find(fields, FieldKind::color, &Field::kind);
    return found == fields.end() ? nullptr : &*found;
}

void append_bytes(std::string& bytes, const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
}

}  // namespace

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

}  // namespace interleaf
