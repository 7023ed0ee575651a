// The lines of a Wavefront OBJ file that make a surface: vertices (v), with their colors where they have
// some, and faces (f), checked.
#pragma once

#include <string>
#include <string_view>

#include "io/mesh/polygon_mesh.h"

namespace interleaf {

/// The mesh, not settled. A line of a vertex or face that ends in a backslash goes on in the next; commas may
/// stand behind numbers, comments behind all. A vertex without a color is white where others have one. \throw
/// InputError naming \p name, the line and what was expected
PolygonMesh read_obj_lines(std::string text, std::string_view name);

}  // namespace interleaf
