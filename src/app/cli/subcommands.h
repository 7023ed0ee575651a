// The subcommands with their options. Each subcommand runs the function of its header NAME_command.h.
#pragma once

#include "app/cli/check_command.h"
#include "app/cli/shared_options.h"

namespace interleaf {

/// Adds every subcommand to \p program, in the order of `--help`.
/// \param checked  receives the result of `check`; must outlive \p program
void add_subcommands(CLI::App& program, CheckResult& checked);

}  // namespace interleaf
