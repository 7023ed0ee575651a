// Scripts that complete command lines in shells, made from the commands and options that --help prints.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/cli/shared_options.h"

namespace interleaf {

enum class Shell { bash, zsh, fish };

std::optional<Shell> shell_named(std::string_view name);

/// A script that completes the names of commands, the options of each, and otherwise files.
std::string shell_completions(const CLI::App& program, Shell shell);

}  // namespace interleaf
