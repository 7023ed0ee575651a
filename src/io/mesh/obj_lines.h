// Reads and checks the lines of a Wavefront OBJ file that describe a surface: vertices (v), with their colors
// if they have any, and faces (f).
#pragma once

#include <string>
#include <string_view>

#include "io/mesh/polygon_mesh.h"

namespace interleaf {

/// Reads the mesh; settle() is for the caller. A vertex or face line that ends in a backslash continues on
/// the next line. A comma may follow a number, and a comment may follow anything. A vertex without a color is
/// white if other vertices have colors.
/// \throw InputError naming \p name, the line and what was expected
PolygonMesh read_obj_lines(std::string text, std::string_view name);

}  // namespace interleaf
