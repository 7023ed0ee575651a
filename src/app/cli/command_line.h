// The command line of `interleaf`: its commands, its options and its exit statuses.
#pragma once

namespace interleaf {

/// Runs the program.
/// \return the exit status: 0 done, 1 the input is at fault, 2 the command line is at fault, 3 the machine is
///     at fault
int run_command_line(int argument_count, const char* const* arguments);

}  // namespace interleaf
