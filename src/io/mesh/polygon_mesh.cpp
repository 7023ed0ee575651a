#include "io/mesh/polygon_mesh.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/mesh/ear_clipping.h"

namespace interleaf {
namespace {

std::string counted(std::size_t count, std::string_view one, std::string_view several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
}

void settle_positions(PolygonMesh& mesh, std::string_view name) {
    if (mesh.broken_vertices.empty()) return;
    std::vector<bool> is_used(mesh.positions.size(), false);
    for (const Index corner : mesh.corners) is_used[corner] = true;
    for (const auto& [vertex, place] : mesh.broken_vertices) {
        if (is_used[vertex])
            throw InputError(
                fmt::format("{}: {}: a coordinate is not a finite number within the range of floats, and "
                            "faces use the vertex",
                            name, place));
        mesh.positions[vertex] = mesh.positions[mesh.corners.front()];
    }
    mesh.remarks.push_back(fmt::format("{} not finite and not used by faces: ignored.",
                                       counted(mesh.broken_vertices.size(), "vertex is", "vertices are")));
}

void settle_colors(PolygonMesh& mesh) {
    std::size_t undefined = 0;
    float most = 0;
    for (glm::vec3& color : mesh.colors) {
        if (std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b)) {
            most = std::max({most, color.r, color.g, color.b});
        } else {
            color = glm::vec3(NAN);
            ++undefined;
        }
    }
    // Colors of films may exceed 1 slightly. Colors that exceed 2 were bytes.
    const float scale = most > 2 ? 1.0F / 255 : 1;
    std::size_t clamped = 0;
    float farthest = 0;
    for (glm::vec3& color : mesh.colors) {
        if (std::isnan(color.r)) {
            color = glm::vec3(1);
            continue;
        }
        // Division by 255, unlike multiplication by its inverse, gives the same floats as every other format.
        const glm::vec3 scaled = scale == 1 ? color : color / 255.0F;
        for (int c = 0; c < 3; ++c) color[c] = std::clamp(scaled[c], 0.0F, 1.0F);
        const float excess = std::max(
            {std::abs(scaled.r - color.r), std::abs(scaled.g - color.g), std::abs(scaled.b - color.b)});
        clamped += excess > 0;
        farthest = std::max(farthest, excess);
    }
    if (scale != 1) mesh.remarks.emplace_back("Colors from 0 to 255 were divided by 255.");
    if (clamped > 0)
        mesh.remarks.push_back(fmt::format("{} outside 0 to 1, by at most {:.2g}, and clamped.",
                                           counted(clamped, "color was", "colors were"), farthest));
    if (undefined > 0)
        mesh.remarks.push_back(fmt::format("{} no finite numbers and became white.",
                                           counted(undefined, "color had", "colors had")));
}

void settle_scalars(PolygonMesh& mesh) {
    std::erase_if(mesh.scalars, [&](const MeshField& scalar) {
        if (!is_field_name(scalar.name)) return true;
        constexpr double most = std::numeric_limits<float>::max();
        if (std::ranges::all_of(scalar.values, [](double value) { return std::abs(value) <= most; }))
            return false;
        mesh.remarks.push_back(
            fmt::format("The values \"{}\" of the vertices are not all finite: left out.", scalar.name));
        return true;
    });
}

/// Says what a mesh without faces is.
std::string what_has_no_faces(const PolygonMesh& mesh) {
    if (mesh.free_forms > 0)
        return fmt::format("has {}, but no faces: only faces are read",
                           counted(mesh.free_forms, "free-form surface", "free-form surfaces"));
    if (mesh.lines > 0)
        return fmt::format("is a wire frame: it has {}, but no faces", counted(mesh.lines, "line", "lines"));
    if (!mesh.positions.empty())
        return fmt::format("is a point cloud: it has {}, but no faces",
                           counted(mesh.positions.size(), "vertex", "vertices"));
    return "has no faces, expected at least one";
}

}  // namespace

bool PolygonMesh::add_face(std::span<const Index> vertices, std::size_t line) {
    corners.insert(corners.end(), vertices.begin(), vertices.end());
    face_sizes.push_back(static_cast<std::uint32_t>(vertices.size()));
    if (line > 0) face_lines.push_back(static_cast<std::uint32_t>(line));
    triangle_count += vertices.size() - 2;
    return triangle_count <= max_triangles;
}

void settle(PolygonMesh& mesh, std::string_view name) {
    if (mesh.face_sizes.empty()) throw InputError(fmt::format("{}: {}", name, what_has_no_faces(mesh)));
    if (mesh.free_forms > 0)
        mesh.remarks.push_back(
            fmt::format("{} left out: only faces are read.",
                        counted(mesh.free_forms, "free-form surface was", "free-form surfaces were")));
    settle_positions(mesh, name);
    settle_colors(mesh);
    settle_scalars(mesh);
}

std::vector<Triangle> triangles_of(const PolygonMesh& mesh, std::string_view name) {
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangle_count);
    const Index* corner = mesh.corners.data();
    std::vector<glm::dvec3> places;
    for (std::size_t face = 0; face < mesh.face_sizes.size(); ++face) {
        const std::span<const Index> corners(corner, mesh.face_sizes[face]);
        corner += corners.size();
        if (corners.size() == 3) {
            triangles.push_back({corners[0], corners[1], corners[2]});
            continue;
        }
        places.clear();
        for (const Index vertex : corners) places.push_back(mesh.positions[vertex]);
        const std::vector<Triangle> parts = divide_polygon(places);
        if (parts.empty())
            throw InputError(fmt::format("{}: {}: a face of {} corners that crosses itself", name,
                                         place_of_face(mesh, face), corners.size()));
        for (const auto& [a, b, c] : parts) triangles.push_back({corners[a], corners[b], corners[c]});
    }
    return triangles;
}

std::string place_of_face(const PolygonMesh& mesh, std::size_t face) {
    if (face < mesh.face_lines.size()) return fmt::format("line {}", mesh.face_lines[face]);
    return fmt::format("face {} (counted from 0)", face);
}

}  // namespace interleaf
