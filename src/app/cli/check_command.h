// `interleaf check`: checks the invariants of keys and the constraints (B) of families (paper, section 3.2).
#pragma once

#include <filesystem>
#include <span>

namespace interleaf {

/// The result for one file. The result for several files is the last of these values that occurs.
enum class CheckResult {
    sound,
    at_fault,
    unread,  ///< cannot be opened or read, so nothing is known about its content
};

/// Prints the result for each file. A sound file gets a line on standard output, and one more line per key
/// whose roots had to be renumbered or marked again. Violations, and the reason why a file cannot be read, go
/// to standard error.
/// \param files  paths that open_family() takes
CheckResult run_check(std::span<const std::filesystem::path> files);

}  // namespace interleaf
