// The lines of a Wavefront OBJ file that make a surface: vertices (v) and faces (f), checked.
//
// tinyobjloader takes a number it cannot read for 0, rounds others, and leaves out a polygon with a vertex
// that does not exist. So every line is checked here, with its number, before tinyobjloader sees it;
// positions are kept as read here, exactly.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

struct ObjLines {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> colors;  ///< one a position when each vertex line has one, 0 to 1; else empty
    std::string text;  ///< OBJ of the v and f lines alone, faces with vertex numbers from 1 and nothing else
    std::size_t triangle_count = 0;  ///< triangles in the faces once they are triangulated
};

/// \throw InputError naming \p name, the line and what was expected: finite numbers, vertices that exist, a
/// face
ObjLines read_obj_lines(std::string_view obj, std::string_view name);

/// The faces as triangles, polygons divided by tinyobjloader. \throw InputError naming \p name, where that
/// cannot be done
std::vector<Triangle> triangles_of(const ObjLines& lines, std::string_view name);

}  // namespace interleaf
