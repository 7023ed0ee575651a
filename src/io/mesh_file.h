// Flat meshes: Wavefront OBJ read (tinyobjloader) and written, PLY written. And pictures: PNG written (stb).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// Reads an OBJ as a hierarchy without bisections; the order of each face's vertices is its marking. Polygons
/// are triangulated, unused vertices dropped; the mesh must be an orientable manifold. Colours of vertices
/// become the field "color".
/// \throw InputError   naming the file, the place and what was expected
/// \throw MachineError when the file cannot be opened or read
Hierarchy read_obj(const std::filesystem::path& file);

/// Reads OBJ files that have the same faces, vertex for vertex, as read_obj() reads the first: it decides how
/// polygons are triangulated and which vertices are dropped. All share one root complex. \throw InputError,
/// MachineError as read_obj(); naming the first face that differs from the first file's
std::vector<Hierarchy> read_obj_series(std::span<const std::filesystem::path> files);

/// Wavefront OBJ as text. Floats are written so that they are read back the same. Each face begins with the
/// vertex opposite its refinement edge. Of \p fields the colour field "color", or else the first one, gives
/// the vertices their colours; OBJ has no place for others.
std::string obj_text(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                     std::span<const Field> fields = {});

/// Binary little-endian PLY. Each of \p fields becomes properties of the vertices: a scalar one float, a
/// colour three bytes. See docs/file-formats.md for their names.
std::string ply_bytes(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                      std::span<const Field> fields = {});

/// An 8-bit RGBA picture, top row first, as the bytes of a PNG file.
std::string png_bytes(std::span<const std::uint8_t> rgba, int width, int height);

}  // namespace interleaf
