// The settings that the program remembers between runs, as a JSON file; docs/user-guide.md lists them. Paths
// are stored as UTF-8. A path that is not UTF-8 is not remembered.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "app/importing/series_import.h"
#include "hierarchy/up_axis.h"
#include "ui/widgets/appearance.h"

namespace interleaf {

/// Paths are absolute.
struct Settings {
    std::vector<std::filesystem::path> recent_files;    ///< most recent first, without duplicates
    std::vector<std::filesystem::path> recent_folders;  ///< as recent_files
    /// By recent files that are series, the options of their last import, where those are not the usual ones.
    std::map<std::filesystem::path, ImportChoices> imports;
    std::filesystem::path last_folder;      ///< where the file browser starts; may be empty
    std::optional<glm::ivec2> window_size;  ///< screen coordinates
    Appearance appearance{};
    bool trackball = false;  ///< whether drags turn the camera as a trackball
    bool axes = true;        ///< whether the view shows its axes
    UpAxis up = UpAxis::y;   ///< of the view

    /// Texts of shortcuts by names of commands; what they mean is not checked here (app/window/shortcuts.h).
    std::map<std::string, std::string> shortcuts;

    bool operator==(const Settings&) const = default;
};

/// The largest number of recent files, and of recent folders.
inline constexpr std::size_t max_recent_paths = 12;

/// Makes \p path absolute, puts it in front of \p recent, and drops paths that exceed max_recent_paths.
void remember(std::vector<std::filesystem::path>& recent, const std::filesystem::path& path);

/// As remember(), for a document. A family.json is remembered as its folder. Of several paths to the same
/// place, for instance through a link, only the latest stays.
void remember_document(std::vector<std::filesystem::path>& recent, const std::filesystem::path& path);

/// As remember_document(), for the series that was imported by \p choices.
void remember_series(Settings& settings, const std::filesystem::path& path, ImportChoices choices);

/// The settings in \p json. \p name stands for the file in messages. Unknown members are ignored.
/// \throw InputError naming the place and what was expected
Settings parse_settings(std::string_view json, std::string_view name);

/// config_folder()/settings.json; none if there is no such folder.
std::optional<std::filesystem::path> settings_file();

struct LoadedSettings {
    Settings settings;
    std::string message;  ///< the fault of the file; empty for none
};

/// Reads \p file. A missing file gives the defaults. A damaged file gives the defaults and a message, and is
/// kept as FILE.damaged, so that writing settings does not destroy a file that the user may want to repair.
LoadedSettings load_settings(const std::filesystem::path& file);

/// Applies \p change to the present content of \p file and writes it, so that the settings of another running
/// program stay. Creates the folder if it is missing.
/// \throw MachineError if the file cannot be written
void change_settings(const std::filesystem::path& file, const std::function<void(Settings&)>& change);

}  // namespace interleaf
