// Family files: family.json with the key files beside it. docs/file-formats.md gives the schema.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "family/family.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

/// Reads a family from a family.json, from the folder that holds one, or, as a family of one key, from a
/// single .ilh or .obj file. Key files must lie inside the family's folder. Keys whose roots are numbered
/// otherwise than those of the first are put over these. What was read has passed check().
/// \param  changes     gets a sentence for each key that was changed for that
/// \throw InputError   naming the file, the place and what was expected; MismatchError where keys have other
///                     roots than the first (synchronise_keys.h)
/// \throw MachineError when a file cannot be opened or read
Family read_family(const std::filesystem::path& path, std::vector<std::string>* changes = nullptr);

/// A new family from key files: .ilh, whose roots are put over those of the first, or .obj. If all are .obj,
/// they must have the same faces; an .obj among .ilh is a key without bisections. Keys are called as their
/// files. Timeline and domain are those of family_of_keys().
/// \param  changes, \throw as read_family()
/// \pre    there is a file
Family read_keys(std::span<const std::filesystem::path> files, std::vector<std::string>* changes = nullptr);

/// The files of the keys that read_family() finds at \p path, in the keys' order.
/// \throw InputError, MachineError as read_family(), for what names them
std::vector<std::filesystem::path> key_files(const std::filesystem::path& path);

/// Writes family.json and the keys as NAME.ilh of this form into \p folder, which is made if missing. Key
/// files that the family.json found there names stay until the new one is in place; then those it does not
/// name are removed.
/// \throw InputError   if check() finds fault with the family
/// \throw MachineError when something cannot be written
void write_family(const Family& family, const std::filesystem::path& folder,
                  const HierarchyFileOptions& form = {});

}  // namespace interleaf
