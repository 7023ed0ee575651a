// Reads files as keys or as meshes to fit, with the readers that the table of formats names.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "family/family.h"
#include "io/file/file_keys.h"
#include "io/mesh/surface_file.h"

namespace interleaf {

/// Makes a new family from key files. All keys are put over the roots of the first key (family_of_files()).
///
/// The reader reads files of one format together: several OBJ files must have the same faces. Files of
/// different formats are read one by one, and the first origin becomes the origin of all keys.
/// \param changes       if given, receives one sentence per remark on a file and per changed key
/// \return              the family; or a misfit, as KeyReader
/// \throw InputError    naming the file, the place and what was expected; MismatchError if a key has other
///                      roots than the first key
/// \throw MachineError  if a file cannot be opened or read
/// \pre                 \p files is not empty
std::variant<Family, Misfit> read_keys_if_fitting(std::span<const std::filesystem::path> files,
                                                  std::vector<std::string>* changes = nullptr);

/// The same, where a misfit is an error.
/// \throw InputError    as read_keys_if_fitting(), and for a misfit
/// \throw MachineError  as read_keys_if_fitting()
Family read_keys(std::span<const std::filesystem::path> files, std::vector<std::string>* changes = nullptr);

/// Reads a mesh to fit a key to.
/// \throw InputError    as the reader of the format, and if no mesh format has the extension of \p file
/// \throw MachineError  as the reader of the format
SurfaceFile read_surface(const std::filesystem::path& file);

}  // namespace interleaf
