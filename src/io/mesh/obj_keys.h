// Reads Wavefront OBJ files as keys. surface_file.h reads them, too, as meshes to fit keys to.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <variant>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
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

}  // namespace interleaf
