// Flat meshes: Wavefront OBJ read and written, PLY written. And pictures: PNG written (stb).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
#include "hierarchy/triangle.h"
#include "io/file/file_keys.h"

namespace interleaf {

/// Reads OBJ files that have the same faces, vertex for vertex, as keys without bisections. The order of each
/// face's vertices is its marking. Polygons are triangulated, unused vertices dropped; the mesh must be an
/// orientable manifold. Colors of vertices become the field "color". The first file decides how polygons are
/// triangulated, which vertices are dropped and what the origin is. All keys share one root complex.
/// \param origin       instead of the first file's
/// \return             the keys; or a misfit where every file that was read is a mesh, but the meshes are not
///                     keys together, such as the first face that differs from the first file's
/// \throw InputError   naming the file, the place and what was expected, where a file is not a mesh
/// \throw MachineError when a file cannot be opened or read
std::variant<FileKeys, Misfit> read_obj_keys(std::span<const std::filesystem::path> files,
                                             std::optional<glm::dvec3> origin = std::nullopt);

/// The same.
/// \throw InputError, MachineError as read_obj_keys(), and for a misfit
FileKeys read_obj_series(std::span<const std::filesystem::path> files,
                         std::optional<glm::dvec3> origin = std::nullopt);

/// The key of one file, wherever its origin is.
Hierarchy read_obj(const std::filesystem::path& file);

/// Wavefront OBJ as text. Floats are written so that they are read back the same. Each face begins with the
/// vertex opposite its refinement edge. Of \p fields the colour field "color", or else the first one, gives
/// the vertices their colors; OBJ has no place for others. \p origin is added to all positions, in double.
std::string obj_text(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                     std::span<const Field> fields = {}, const glm::dvec3& origin = glm::dvec3(0));

/// Binary little-endian PLY. Each of \p fields becomes properties of the vertices: a scalar one float, a
/// color three bytes. See docs/file-formats.md for their names. Where \p origin is not 0 it is added to all
/// positions, which are doubles then.
std::string ply_bytes(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                      std::span<const Field> fields = {}, const glm::dvec3& origin = glm::dvec3(0));

/// An 8-bit RGBA picture, top row first, as the bytes of a PNG file.
std::string png_bytes(std::span<const std::uint8_t> rgba, int width, int height);

}  // namespace interleaf
