// Opening: looks at files and says what they are. The command line, a drop, the file browser, *Reopen* and
// *Add keys* all ask here.
//
// A new kind of source is one more alternative of Opening. Users that open name all alternatives (std::visit),
// so the compiler lists the places that must say what to do with the new one. `check` and `info` look for
// meshes alone and treat everything else as a family.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "family/family.h"

namespace interleaf {

/// A family as its file describes it.
struct OpenedFamily {
    Family family;
    std::vector<std::string> changes;  ///< a sentence for each key that was changed
};

/// A new family of one key per file.
struct OpenedKeys {
    Family family;
    std::vector<std::string> changes;          ///< a sentence for each remark and each key that was changed
    std::vector<std::filesystem::path> files;  ///< in the keys' order

    /// Whether every file holds a mesh, to which a key can be fitted instead.
    bool can_be_fitted() const;
};

/// Meshes that are not keys as they are.
struct MeshesToFit {
    std::vector<std::filesystem::path> files;
    std::string reason;  ///< why they are not keys; empty where their formats hold no keys
};

using Opening = std::variant<OpenedFamily, OpenedKeys, MeshesToFit>;

/// The cases of a std::visit() over an Opening, one lambda per alternative.
template <typename... Functions>
struct Cases : Functions... {
    using Functions::operator()...;
};
template <typename... Functions>
Cases(Functions...) -> Cases<Functions...>;

/// Opens \p paths, as files_of() resolves them:
/// - no path: the built-in family
/// - one family file, or its folder: the family
/// - meshes, at least one of a format without keys: meshes to fit
/// - several meshes that are not keys together: meshes to fit, with the reason
/// - other files: keys
/// \throw InputError, MachineError as files_of(), read_family() and read_keys()
Opening open_files(std::span<const std::filesystem::path> paths);

/// The same where meshes cannot be fitted.
/// \param changes     gets the changes of the opened keys
/// \throw InputError  for meshes to fit, too, naming what was expected
Family open_family(std::span<const std::filesystem::path> paths, std::vector<std::string>* changes = nullptr);

/// The family of \p opened, as open_family() gives it.
Family family_of(Opening opened, std::vector<std::string>* changes = nullptr);

/// Whether \p path is a folder with a family.json.
bool is_family_folder(const std::filesystem::path& path);

/// The files that a folder without family.json stands for, in natural order: its files of formats that hold
/// keys alone, or else its meshes. None for a family's folder, and for a path that is not a folder.
std::vector<std::filesystem::path> files_in_folder(const std::filesystem::path& path);

/// The files that \p paths stand for. A pattern such as flow.*.obj stands for the files that match, in
/// natural order (file_pattern.h), a folder of keys or meshes for its files, another path for itself. Files
/// that differ only in numbers are put in natural order; other files stay in the given order. \throw
/// InputError, MachineError as matching_files(); InputError for a file that does not exist
std::vector<std::filesystem::path> files_of(std::span<const std::filesystem::path> paths);

}  // namespace interleaf
