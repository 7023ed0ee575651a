// Reads and writes Wavefront OBJ, writes PLY, and writes PNG pictures (stb).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "family/field_scale.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/triangle.h"
#include "io/file/file_keys.h"

namespace interleaf {

/// Reads OBJ files that have the same faces, vertex for vertex, as keys without bisections. The order of the
/// vertices of each face marks its refinement edge. The reader triangulates polygons and drops unused
/// vertices; the mesh must be an orientable manifold. Colors of vertices become the field "color". The first
/// file determines how polygons are triangulated, which vertices are dropped and what the origin is. All keys
/// share one root complex.
/// \param origin       replaces the origin of the first file
/// \return             the keys; or a misfit if all files are meshes that are not keys together. Its reason
///                     names, for example, the first face that differs from the faces of the first file
/// \throw InputError   naming the file, the place and what was expected, if a file is not a mesh
/// \throw MachineError if a file cannot be opened or read
std::variant<FileKeys, Misfit> read_obj_keys(std::span<const std::filesystem::path> files,
                                             std::optional<glm::dvec3> origin = std::nullopt);

/// As read_obj_keys().
/// \throw InputError, MachineError as read_obj_keys(); InputError also for a misfit
FileKeys read_obj_series(std::span<const std::filesystem::path> files,
                         std::optional<glm::dvec3> origin = std::nullopt);

/// Reads the key of one file. Drops the origin, if the file has one.
Hierarchy read_obj(const std::filesystem::path& file);

/// The text of a Wavefront OBJ file. Reading it gives exactly the same floats. Each face begins with the
/// vertex opposite its refinement edge.
/// \param fields  the color field "color", or else the first color field, gives the colors of the vertices;
///                OBJ has no place for other fields
/// \param origin  is added to all positions, in double precision
std::string obj_text(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                     std::span<const Field> fields = {}, const glm::dvec3& origin = glm::dvec3(0));

/// The bytes of a binary little-endian PLY file.
/// \param fields  become properties of the vertices: a float for a scalar, three bytes for a color;
///                docs/file-formats.md describes the names
/// \param origin  is added to all positions; unless it is 0, positions are written as doubles
/// \param scales  their offsets are added to the fields, which then are doubles
std::string ply_bytes(std::span<const Triangle> triangles, std::span<const glm::vec3> positions,
                      std::span<const Field> fields = {}, const glm::dvec3& origin = glm::dvec3(0),
                      std::span<const FieldScale> scales = {});

/// The bytes of a PNG file.
/// \param rgba  the picture, 8 bits per channel, top row first; 4 \p width \p height bytes
std::string png_bytes(std::span<const std::uint8_t> rgba, int width, int height);

}  // namespace interleaf
