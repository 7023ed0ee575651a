// The subcommands with their options. Each runs its function of NAME_command.h.
#pragma once

#include "app/cli/check_command.h"
#include "app/cli/shared_options.h"

namespace interleaf {

/// Adds every subcommand to \p program, in the order of `--help`.
/// \param checked  gets the result of `check`; must outlive \p program
void add_subcommands(CLI::App& program, CheckResult& checked);

}  // namespace interleaf
