// The commands that print how the program is called: help, manual and completions. Other parts of the system
// read what the last two print.
#pragma once

#include "app/cli/shared_options.h"

namespace interleaf {

/// Adds `help [COMMAND]`, `manual` and `completions SHELL`.
/// \param program  with all other commands; it must outlive the parsing
void add_reference_subcommands(CLI::App& program);

}  // namespace interleaf
