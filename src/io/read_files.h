// Reads files as what they are wanted for, by the readers that the table of formats names.
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

/// A new family from key files, whose roots are put over those of the first (family_of_files()). Files that
/// all have one format are read together: several OBJ files must have the same faces. In a mixture each file
/// is read alone, and the first origin is that of all.
/// \param  changes      gets a sentence for each remark on a file and for each key that was changed
/// \return              the family; or a misfit, as KeyReader
/// \throw InputError    naming the file, the place and what was expected; MismatchError where keys have other
///                      roots than the first
/// \throw MachineError  when a file cannot be opened or read
/// \pre    there is a file
std::variant<Family, Misfit> read_keys_if_fitting(std::span<const std::filesystem::path> files,
                                                  std::vector<std::string>* changes = nullptr);

/// The same.
/// \throw InputError, MachineError as read_keys_if_fitting(), and for a misfit
Family read_keys(std::span<const std::filesystem::path> files, std::vector<std::string>* changes = nullptr);

/// Reads a mesh to fit a key to.
/// \throw InputError, MachineError as the reader of its format; InputError where no format of meshes has the
///        extension of \p file
SurfaceFile read_surface(const std::filesystem::path& file);

}  // namespace interleaf
