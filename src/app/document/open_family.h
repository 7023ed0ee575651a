// Opening: what the words on a command line, or files dropped on the window, stand for.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "family/family.h"

namespace interleaf {

/// Whether \p path is a folder with a family.json.
bool is_family_folder(const std::filesystem::path& path);

/// The files that a folder without family.json stands for, in their natural order: its keys, .ilh, or where
/// it has none its meshes. None for a family's folder, and for what is no folder.
std::vector<std::filesystem::path> files_in_folder(const std::filesystem::path& path);

/// The files that \p paths stand for: a pattern such as flow.*.obj for the files that match it in their
/// natural order (file_pattern.h), a folder of keys or meshes for these, another path for itself. Several
/// that differ only in numbers are put in natural order, too; others stay in the given order. \throw
/// InputError, MachineError as matching_files(); InputError for a file that is not there
std::vector<std::filesystem::path> files_of(std::span<const std::filesystem::path> paths);

/// Opens the built-in family without \p paths, a family as read_family() takes it, or several .ilh and .obj
/// files as a new family, as read_keys() makes it.
/// \param changes     gets a sentence for each key whose roots were renumbered or marked anew
/// \throw InputError, MachineError as files_of(), read_family() and read_keys()
Family open_family(std::span<const std::filesystem::path> paths, std::vector<std::string>* changes = nullptr);

}  // namespace interleaf
