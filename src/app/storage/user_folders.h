// Where the program keeps files of its own, after the XDG Base Directory Specification 0.8.
#pragma once

#include <filesystem>
#include <optional>

namespace interleaf {

/// For settings: $XDG_CONFIG_HOME/interleaf, by default ~/.config/interleaf; none where neither is known. It
/// need not exist. As the specification wants it, a relative path in the variable counts as unset.
std::optional<std::filesystem::path> config_folder();

/// For what is neither settings nor a document, as the recovery: $XDG_STATE_HOME/interleaf, by default
/// ~/.local/state/interleaf; the same holds.
std::optional<std::filesystem::path> state_folder();

}  // namespace interleaf
