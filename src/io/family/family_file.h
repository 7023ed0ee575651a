// Family files: family.json with the key files beside it. docs/file-formats.md describes the schema.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "family/family.h"
#include "hierarchy/progress.h"
#include "io/file/file_keys.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

/// Reads a family. The result has passed check(). Key files must be inside the folder of the family. If the
/// roots of a key are numbered differently than the roots of the first key, the key is renumbered.
/// \param path         a family.json, or the folder that holds one
/// \param changes      gets a sentence for each key that was renumbered
/// \throw InputError   naming the file, the place and what was expected; MismatchError if the roots of a key
///                     do not match the roots of the first key (synchronize_keys.h)
/// \throw MachineError if a file cannot be opened or read
Family read_family(const std::filesystem::path& path, std::vector<std::string>* changes = nullptr);

/// The same, with progress per key.
/// \throw Cancelled    when \p progress says so
Family read_family(const std::filesystem::path& path, std::vector<std::string>* changes,
                   const Progress& progress);

/// Makes a new family of keys that were read from \p files. All keys are put over the roots of the first key.
/// Each key has its name, or else the name of its file. Timeline and domain are those of family_of_keys().
/// \param changes       gets the remarks on the files, then a sentence for each key that was renumbered
/// \throw MismatchError naming the file, if the roots of a key do not match the roots of the first key
/// \pre   there is a file, and one key per file or one source per key
Family family_of_files(std::span<const std::filesystem::path> files, FileKeys read,
                       std::vector<std::string>* changes = nullptr);

/// The key files that read_family() would read for \p path, in the order of the keys.
/// \throw InputError, MachineError as read_family(), if family.json cannot be read or understood
std::vector<std::filesystem::path> key_files(const std::filesystem::path& path);

/// Writes family.json and the keys as NAME.ilh of this form into \p folder, which is made if missing. Key
/// files that the family.json found there names stay until the new one is in place; then those it does not
/// name are removed.
/// \throw InputError   if check() finds fault with the family
/// \throw MachineError when something cannot be written
void write_family(const Family& family, const std::filesystem::path& folder,
                  const HierarchyFileOptions& form = {});

}  // namespace interleaf
