// Reads glTF 2.0 files (.glb and .gltf): a mesh with morph targets as a family of keys with equal
// connectivity, any other mesh as one key or as a mesh to fit a key to. Of a scene with morph targets, the
// first mesh that has some counts.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "family/family.h"
#include "io/file/file_keys.h"
#include "io/mesh/surface_file.h"

namespace interleaf {

/// Reads the keys of a file, with the timeline, domain and origin that export_glb() wrote.
///
/// Vertices are welded where the base and all targets have the same positions, because other programs split
/// vertices along the seams of textures; not in files of export_glb(). The order of the corners of each
/// triangle marks its refinement edge. An animation of the weights becomes the timeline (weight_timeline.h).
/// \param changes      if given, receives one sentence per remark on the file
/// \throw InputError   naming the file, the place and what was expected, also if the mesh is no manifold
/// \throw MachineError if a file cannot be opened or read
Family read_gltf_family(const std::filesystem::path& file, std::vector<std::string>* changes = nullptr);

/// The keys of several files, without timelines and domains; a KeyReader (formats.h).
/// \throw InputError, MachineError as read_gltf_family()
std::variant<FileKeys, Misfit> read_gltf_keys(std::span<const std::filesystem::path> files,
                                              std::optional<glm::dvec3> origin = std::nullopt);

/// The bytes of a file as a mesh without its targets; a SurfaceParser (surface_file.h).
/// \param name  the path of the file; buffers of a .gltf may be files of the same folder
/// \throw InputError, MachineError as read_gltf_family()
SurfaceFile parse_gltf(std::string_view bytes, std::string_view name);

}  // namespace interleaf
