// Family files: family.json with the key files beside it. docs/file-formats.md gives the schema.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "family/family.h"

namespace interleaf {

/// Reads a family from a family.json, from the folder that holds one, or, as a family of one key, from a
/// single .ilh or .obj file. Key files must lie inside the family's folder. What was read has passed check().
/// \throw InputError   naming the file, the place and what was expected
/// \throw MachineError when a file cannot be opened or read
Family read_family(const std::filesystem::path& path);

/// The files of the keys that read_family() finds at \p path, in the keys' order.
/// \throw InputError, MachineError as read_family(), for what names them
std::vector<std::filesystem::path> key_files(const std::filesystem::path& path);

/// The extension of \p file as read_family() takes it: ".ILH" as ".ilh".
std::string lower_case_extension(const std::filesystem::path& file);

/// Writes family.json and the keys as NAME.ilh into \p folder, which is made if missing. Key files that the
/// family.json found there names stay until the new one is in place; then those it does not name are removed.
/// \throw InputError   if check() finds fault with the family, or a name is not UTF-8 without control
/// characters \throw MachineError when something cannot be written
void write_family(const Family& family, const std::filesystem::path& folder);

}  // namespace interleaf
