// Opening: looks at files and determines what they are. The command line, a drop, the file browser, *Reopen*
// and *Add keys* all use these functions.
//
// A new kind of source is one more alternative of Opening. The window and family_of() name all alternatives
// (std::visit), so the compiler lists the places that must say what to do with the new one. Commands use family_of(),
// which imports a series at once; the window imports it on a worker. Three commands first look for some alternatives:
// `check` for meshes to fit, `lod` for series and keys, and `info` for families and series.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "family/family.h"
#include "hierarchy/progress.h"

namespace interleaf {

/// A family as its file describes it.
struct OpenedFamily {
    Family family;
    std::vector<std::string> changes;  ///< one sentence per changed key
};

/// A new family of the keys in files: one key per file, or several in a glTF file.
struct OpenedKeys {
    Family family;
    std::vector<std::string> changes;          ///< one sentence per remark and per changed key
    std::vector<std::filesystem::path> files;  ///< in the keys' order

    /// Whether every file holds a mesh, to which a key can be fitted instead.
    bool can_be_fitted() const;
};

/// Meshes that cannot serve as keys without a fit.
struct MeshesToFit {
    std::vector<std::filesystem::path> files;
    std::string reason;  ///< why they are not keys; empty if their formats hold no keys
};

/// Steps of a series from numerics. Their keys are recovered, which takes time (app/importing).
struct SeriesToImport {
    std::vector<std::filesystem::path> files;
};

using Opening = std::variant<OpenedFamily, OpenedKeys, MeshesToFit, SeriesToImport>;

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
/// - one file with a family that could also be fitted (glTF): keys
/// - one or several steps of a series, or a list of them (.pvd, .series): a series to import
/// - meshes, at least one of a format without keys: meshes to fit
/// - several meshes that are not keys together: meshes to fit, with the reason
/// - other files: keys
/// \param progress  of families with a family.json, per key; other files are read without
/// \throw InputError, MachineError as files_of(), read_family() and read_keys()
/// \throw Cancelled when \p progress says so
Opening open_files(std::span<const std::filesystem::path> paths, const Progress& progress = {});

/// As open_files(), for callers that cannot fit meshes.
/// \param changes     receives the changes of the opened keys
/// \throw InputError  also for meshes to fit, naming what was expected
Family open_family(std::span<const std::filesystem::path> paths, std::vector<std::string>* changes = nullptr);

/// Imports a series with the usual choices.
/// \throw InputError, MachineError as import_series()
OpenedKeys import_steps(const SeriesToImport& series);

/// The family of \p opened, as open_family() returns it.
Family family_of(Opening opened, std::vector<std::string>* changes = nullptr);

/// Whether \p path is a folder with a family.json.
bool is_family_folder(const std::filesystem::path& path);

/// The files of a folder without family.json, in natural order: the files whose formats hold only keys, or,
/// if there are none, the meshes. Empty for the folder of a family, and for a path that is not a folder.
std::vector<std::filesystem::path> files_in_folder(const std::filesystem::path& path);

/// The files that \p paths stand for. A pattern such as flow.*.obj stands for the files that match, in
/// natural order (file_pattern.h). A folder of keys or meshes stands for its files. Any other path stands for
/// itself. Files whose names differ only in numbers are sorted in natural order; other files keep the given
/// order.
/// \throw InputError, MachineError as matching_files(); InputError for a file that does not exist
std::vector<std::filesystem::path> files_of(std::span<const std::filesystem::path> paths);

}  // namespace interleaf
