// The folders of the program's own files, according to the XDG Base Directory Specification 0.8.
#pragma once

#include <filesystem>
#include <optional>

namespace interleaf {

/// The folder of the settings: $XDG_CONFIG_HOME/interleaf, by default ~/.config/interleaf; none if neither is
/// known. The folder need not exist. As the specification demands, a relative path in the variable counts as
/// unset.
std::optional<std::filesystem::path> config_folder();

/// The folder of files that are neither settings nor documents, such as the recoveries:
/// $XDG_STATE_HOME/interleaf, by default ~/.local/state/interleaf. Otherwise as config_folder().
std::optional<std::filesystem::path> state_folder();

}  // namespace interleaf
