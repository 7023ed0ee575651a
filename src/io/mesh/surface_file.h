// Triangle surfaces as other programs write them: Wavefront OBJ, PLY, STL and OFF, without order in their
// faces or trust in their content.
//
// Each form is read by own code, a page for each: assimp 5.2.5, the packaged library under a permissive
// licence, hung for seconds on every third PLY file with a few bytes changed; tinyobjloader takes a number
// that it cannot read for 0, divides concave polygons wrongly, and takes 25 times the memory of a file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"
#include "io/mesh/polygon_mesh.h"

namespace interleaf {

/// What a file says, nothing welded or turned; positions are finite, and every vertex exists.
struct SurfaceFile {
    std::vector<glm::dvec3> positions;
    std::vector<Triangle> triangles;
    std::vector<glm::vec3> colors;  ///< one per vertex, 0 to 1; empty for none

    /// Sentences about what was read otherwise than it stands there.
    std::vector<std::string> remarks;
};

/// Reads a surface from the bytes of a file of one format. Polygons become triangles (ear_clipping.h).
/// \p name stands for the file in messages.
/// \throw InputError naming the file, the place and what was expected
using SurfaceParser = SurfaceFile (*)(std::string_view bytes, std::string_view name);

SurfaceFile parse_obj(std::string_view bytes, std::string_view name);
SurfaceFile parse_off(std::string_view bytes, std::string_view name);
SurfaceFile parse_ply(std::string_view bytes, std::string_view name);
SurfaceFile parse_stl(std::string_view bytes, std::string_view name);

/// Reads \p file, at most 1 GiB, with the parser of its format. Coordinates that have lost their digits get
/// a remark.
/// \throw InputError   as \p parse
/// \throw MachineError when the file cannot be opened or read
SurfaceFile read_surface(const std::filesystem::path& file, SurfaceParser parse);

/// What is said of a mesh as triangles. \throw InputError as settle() and triangles_of()
SurfaceFile surface_of(PolygonMesh mesh, std::string_view name);

}  // namespace interleaf
