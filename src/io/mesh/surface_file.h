// Reads triangle surfaces that other programs wrote, as Wavefront OBJ, PLY, STL or OFF. The order of faces
// has no meaning, and the readers trust nothing in a file.
//
// Each format has its own short reader here, because the packaged libraries do not fit. assimp 5.2.5 hung for
// seconds on every third PLY file with a few bytes changed. tinyobjloader reads a malformed number as 0,
// divides concave polygons wrongly, and takes 25 times the memory of the file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/field_mesh.h"
#include "hierarchy/triangle.h"
#include "io/mesh/polygon_mesh.h"

namespace interleaf {

/// The content of a file. Nothing is welded or reoriented. All positions are finite, and triangles name
/// existing vertices.
struct SurfaceFile {
    std::vector<glm::dvec3> positions;
    std::vector<Triangle> triangles;
    std::vector<glm::vec3> colors;  ///< one per vertex, 0 to 1; empty if there are none

    /// Fields of one component with one finite value per vertex. Their names differ, and can be names of a key's
    /// fields.
    std::vector<MeshField> scalars{};

    /// Sentences about everything that was read differently than written.
    std::vector<std::string> remarks;
};

/// Reads the bytes of a file of one format. Polygons become triangles (ear_clipping.h). Messages call the file
/// \p name.
/// \throw InputError naming the file, the place and what was expected
using SurfaceParser = SurfaceFile (*)(std::string_view bytes, std::string_view name);

SurfaceFile parse_obj(std::string_view bytes, std::string_view name);
SurfaceFile parse_off(std::string_view bytes, std::string_view name);
SurfaceFile parse_ply(std::string_view bytes, std::string_view name);
SurfaceFile parse_stl(std::string_view bytes, std::string_view name);

/// Reads a file of at most 1 GiB with the parser of its format. Adds a remark if coordinates have lost their
/// digits.
/// \throw InputError   as \p parse
/// \throw MachineError if the file cannot be opened or read
SurfaceFile parse_file(const std::filesystem::path& file, SurfaceParser parse);

/// Settles \p mesh and divides its polygons into triangles.
/// \throw InputError as settle() and triangles_of()
SurfaceFile surface_of(PolygonMesh mesh, std::string_view name);

}  // namespace interleaf
