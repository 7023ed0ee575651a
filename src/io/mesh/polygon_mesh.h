// A mesh as read from a file, before its polygons are divided and its oddities are settled.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/field.h"
#include "hierarchy/field_mesh.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// The largest number of vertices without finite coordinates. A file with more counts as damaged.
inline constexpr std::size_t max_broken_vertices = 1000;
inline constexpr std::string_view too_many_broken_vertices = "more than 1000 vertices are not finite";

/// The largest number of triangles in a file of \p bytes bytes. A mesh has about two triangles per vertex,
/// and the vertices alone take more bytes than this limit. A file with more triangles repeats the same few
/// vertices.
constexpr std::size_t max_triangles_of(std::size_t bytes) {
    return bytes / 4 + 1'000'000;
}
inline constexpr std::string_view too_many_triangles = "more triangles than a file of its size can have";

/// Whether all coordinates are numbers in the range of floats.
inline bool is_place(const glm::dvec3& position) {
    constexpr double most = std::numeric_limits<float>::max();
    return std::abs(position.x) <= most && std::abs(position.y) <= most && std::abs(position.z) <= most;
}

/// The largest number of scalars: a key has room for these and for a color.
inline constexpr std::size_t max_mesh_scalars = max_field_count - 1;

struct PolygonMesh {
    std::vector<glm::dvec3> positions;  ///< NaN where the file has no number
    std::vector<glm::vec3> colors;      ///< one per vertex, in any range; empty if there are none
    std::vector<MeshField> scalars;     ///< of one component, one value per vertex; at most max_mesh_scalars
    std::vector<Index> corners;         ///< vertices of the faces, one face after the other
    std::vector<std::uint32_t> face_sizes;  ///< number of corners per face
    std::vector<std::uint32_t> face_lines;  ///< line of the file per face; empty if the file has no lines
    std::size_t triangle_count = 0;         ///< number of triangles that the faces become
    std::size_t max_triangles = 0;          ///< limit of triangle_count (max_triangles_of)

    std::size_t lines = 0;       ///< polylines or edges, which are passed over
    std::size_t free_forms = 0;  ///< free-form surfaces, which are passed over

    /// Vertices with a coordinate that is not a number or is beyond the range of floats, each with its place
    /// in the file, such as "line 12".
    std::vector<std::pair<Index, std::string>> broken_vertices;

    /// Sentences about everything that was read differently than written.
    std::vector<std::string> remarks;

    /// Adds a vertex.
    /// \param place  gives the place of the vertex in the file; called if \p position is not finite
    /// \return       whether there are at most max_broken_vertices broken vertices
    template <typename Place>
    [[nodiscard]] bool add_vertex(const glm::dvec3& position, Place place) {
        if (!is_place(position)) broken_vertices.emplace_back(static_cast<Index>(positions.size()), place());
        positions.push_back(position);
        return broken_vertices.size() <= max_broken_vertices;
    }

    /// Adds a face.
    /// \param line  the line of the file; 0 if the file has no lines
    /// \return      whether there are at most max_triangles triangles
    [[nodiscard]] bool add_face(std::span<const Index> vertices, std::size_t line = 0);
};

/// Gives the mesh the numbers that its users expect, and adds remarks about what was changed. A broken
/// vertex, which no face may use, gets the position of another vertex. Scalars that are not finite, or whose names
/// cannot be names of fields, are left out. Colors are clamped to 0 to 1, after
/// division by 255 if they range to 255.
/// \pre   faces name existing vertices
/// \throw InputError naming \p name, if there are no faces, or if a face uses a broken vertex
void settle(PolygonMesh& mesh, std::string_view name);

/// The triangles of all faces, face after face (ear_clipping.h).
/// \throw InputError naming \p name and the place of a face that crosses itself
std::vector<Triangle> triangles_of(const PolygonMesh& mesh, std::string_view name);

/// The place of a face in the file: "line 12", or "face 3 (counted from 0)" if the file has no lines.
std::string place_of_face(const PolygonMesh& mesh, std::size_t face);

}  // namespace interleaf
