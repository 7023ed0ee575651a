// The lines of a Wavefront OBJ file that make a surface: vertices (v), with their colours where they have
// some, and faces (f), checked.
//
// tinyobjloader takes a number it cannot read for 0, rounds others, leaves out a polygon with a vertex that
// does not exist, and takes 25 times the memory of a file. So every line is read and checked here, with its
// number; tinyobjloader only divides polygons.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// Dividing a polygon takes time that grows with the square of its corners.
inline constexpr std::size_t most_corners = 1000;

struct ObjLines {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> colors;  ///< one a vertex, white where its line has none; empty when none has
    std::vector<Index> corners;     ///< vertices of the faces, one face after the other
    std::vector<std::uint16_t> face_sizes;  ///< corners of each face, 3 to most_corners
    std::size_t triangle_count = 0;         ///< triangles in the faces once they are triangulated
};

/// \throw InputError naming \p name, the line and what was expected: finite numbers, colours from 0 to 1,
/// vertices that exist, a face
ObjLines read_obj_lines(std::string_view obj, std::string_view name);

/// The faces as triangles, polygons divided by tinyobjloader. \throw InputError naming \p name, where that
/// cannot be done
std::vector<Triangle> triangles_of(const ObjLines& lines, std::string_view name);

}  // namespace interleaf
