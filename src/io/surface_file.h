// Triangle surfaces as other programs write them: Wavefront OBJ, PLY, STL and OFF, without order in their
// faces or trust in their content.
//
// OBJ is read by tinyobjloader behind a check of every line (obj_lines.h). The others are read by own code, a
// page for each: assimp 5.2.5, the packaged library under a permissive licence, hung for seconds on every
// third PLY file with a few bytes changed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// What a file says, nothing welded, turned or left out; positions are finite, and every vertex exists.
struct SurfaceFile {
    std::vector<glm::dvec3> positions;
    std::vector<Triangle> triangles;
    std::vector<glm::vec3> colors;  ///< one a vertex, 0 to 1; empty for none
};

/// Reads a surface of at most 1 GiB, by the extension of \p file: .obj, .ply, .stl or .off. Polygons become
/// triangles: in an OBJ by their shape, in the others as a fan around their first corner.
/// \throw InputError   naming the file, the place and what was expected
/// \throw MachineError when the file cannot be opened or read
SurfaceFile read_surface(const std::filesystem::path& file);

/// The same from the bytes of a file of one form; \p name stands for the file in messages.
SurfaceFile parse_off(std::string_view bytes, std::string_view name);
SurfaceFile parse_ply(std::string_view bytes, std::string_view name);
SurfaceFile parse_stl(std::string_view bytes, std::string_view name);

/// Corners of a polygon, at most.
inline constexpr std::size_t most_polygon_corners = 1000;

/// Appends a polygon as a fan. \pre it has at least 3 corners
void append_fan(std::vector<Triangle>& triangles, std::span<const Index> corners);

}  // namespace interleaf
