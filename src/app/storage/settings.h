// What the program remembers from one run to the next, as a JSON file: docs/user-guide.md says which. Paths
// are kept as UTF-8; one that is not UTF-8 is not remembered.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace interleaf {

/// Paths are absolute.
struct Settings {
    std::vector<std::filesystem::path> recent_files;    ///< most recent first, each once
    std::vector<std::filesystem::path> recent_folders;  ///< the same
    std::filesystem::path last_folder;                  ///< shown first by the file browser; may be empty
    std::optional<glm::ivec2> window_size;              ///< screen coordinates

    bool operator==(const Settings&) const = default;
};

/// Of files, and of folders.
inline constexpr std::size_t max_recent_paths = 12;

/// Puts \p path in front of \p recent, made absolute, and drops what is too old.
void remember(std::vector<std::filesystem::path>& recent, const std::filesystem::path& path);

/// The same for a document: a family.json is remembered as its folder, and of paths that lead to the same
/// place, as through a link, only the latest is kept.
void remember_document(std::vector<std::filesystem::path>& recent, const std::filesystem::path& path);

/// The settings in \p json; \p name stands for the file in messages. Members it does not know are passed
/// over. \throw InputError naming the place and what was expected
Settings parse_settings(std::string_view json, std::string_view name);

/// config_folder()/settings.json; none where there is no such folder.
std::optional<std::filesystem::path> settings_file();

struct LoadedSettings {
    Settings settings;
    std::string message;  ///< what was wrong with the file; empty if nothing
};

/// Reads \p file. A missing file gives the defaults; a damaged one does so with a message, and is kept as
/// FILE.damaged, so that writing settings does not destroy what a person may want to mend.
LoadedSettings load_settings(const std::filesystem::path& file);

/// Applies \p change to what \p file holds by now, so that what another running program has remembered stays,
/// and writes it; the folder is made if missing.
/// \throw MachineError when it cannot be written
void change_settings(const std::filesystem::path& file, const std::function<void(Settings&)>& change);

}  // namespace interleaf
