// What a file says of a mesh, before its polygons are divided and its oddities settled.
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

#include "hierarchy/triangle.h"

namespace interleaf {

/// Vertices that are not at a finite place, at most: more are as good as a damaged file.
inline constexpr std::size_t max_broken_vertices = 1000;
inline constexpr std::string_view too_many_broken_vertices =
    "more than 1000 vertices are not at a finite place";

/// Triangles that a file of \p bytes stands for at most. A mesh has about two for each vertex, and these
/// alone take more bytes; what says more names the same few vertices again and again.
constexpr std::size_t max_triangles_of(std::size_t bytes) {
    return bytes / 4 + 1'000'000;
}
inline constexpr std::string_view too_many_triangles = "more triangles than a file of its size can have";

/// Whether all coordinates are numbers within the range of floats.
inline bool is_place(const glm::dvec3& position) {
    constexpr double most = std::numeric_limits<float>::max();
    return std::abs(position.x) <= most && std::abs(position.y) <= most && std::abs(position.z) <= most;
}

struct PolygonMesh {
    std::vector<glm::dvec3> positions;      ///< NaN where the file has no number
    std::vector<glm::vec3> colors;          ///< one per vertex, of any range; empty for none
    std::vector<Index> corners;             ///< vertices of the faces, one face after the other
    std::vector<std::uint32_t> face_sizes;  ///< corners of each face
    std::vector<std::uint32_t> face_lines;  ///< of the file; empty where it has no lines
    std::size_t triangle_count = 0;         ///< that the faces become
    std::size_t max_triangles = 0;          ///< (max_triangles_of)

    /// A vertex with a coordinate that is no number, or beyond the range of floats, and where it is in the
    /// file: "line 12".
    std::vector<std::pair<Index, std::string>> broken_vertices;

    /// Sentences about what the file does not say so, but was read as.
    std::vector<std::string> remarks;

    /// \param place   gives where it is in the file, should the position be none
    /// \return        whether that is so for no more than max_broken_vertices
    template <typename Place>
    [[nodiscard]] bool add_vertex(const glm::dvec3& position, Place place) {
        if (!is_place(position)) broken_vertices.emplace_back(static_cast<Index>(positions.size()), place());
        positions.push_back(position);
        return broken_vertices.size() <= max_broken_vertices;
    }

    /// \param line  of the file; 0 for none
    /// \return      whether there are no more triangles than max_triangles
    [[nodiscard]] bool add_face(std::span<const Index> vertices, std::size_t line = 0);
};

/// Makes the mesh one whose numbers are what others expect: a vertex without a place, which no face may use,
/// goes to where another is; colors go to 0 to 1, from 0 to 255 where they need it. Remarks say what was
/// done. \pre  faces name vertices that exist \throw InputError naming \p name, where there are no faces, or
/// a face uses a broken vertex
void settle(PolygonMesh& mesh, std::string_view name);

/// The faces as triangles, each face's in a row (ear_clipping.h).
/// \throw InputError naming \p name and the line, or else the number, of a face that crosses itself
std::vector<Triangle> triangles_of(const PolygonMesh& mesh, std::string_view name);

/// "line 12", or "face 3 (counted from 0)".
std::string place_of_face(const PolygonMesh& mesh, std::size_t face);

}  // namespace interleaf
