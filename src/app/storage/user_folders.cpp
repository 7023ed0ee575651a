#include "app/storage/user_folders.h"

#include <cstdlib>

namespace interleaf {

namespace {

namespace fs = std::filesystem;

/// The absolute path in the environment variable \p name, if there is one.
std::optional<fs::path> folder_in(const char* name) {
    const char* const value = std::getenv(name);
    if (value == nullptr || !fs::path(value).is_absolute()) return std::nullopt;
    return value;
}

std::optional<fs::path> own_folder(const char* variable, const char* below_home) {
    if (const auto folder = folder_in(variable)) return *folder / "interleaf";
    if (const auto home = folder_in("HOME")) return *home / below_home / "interleaf";
    return std::nullopt;
}

}  // namespace

std::optional<fs::path> config_folder() {
    return own_folder("XDG_CONFIG_HOME", ".config");
}

std::optional<fs::path> state_folder() {
    return own_folder("XDG_STATE_HOME", ".local/state");
}

}  // namespace interleaf
