// `interleaf check`: the invariants of keys and constraints (B) of families (paper, section 3.2).
#pragma once

#include <filesystem>
#include <span>

namespace interleaf {

/// Of several files the last of these that is true of one.
enum class CheckResult {
    sound,
    at_fault,
    unread,  ///< cannot be opened or read here, so nothing is known of it
};

/// Prints a line for each of \p files, each as open_family() takes it: on standard output when it is sound,
/// with a line more for each key whose roots had to be renumbered or marked anew; else, with every violation
/// or why it cannot be read, on standard error
CheckResult run_check(std::span<const std::filesystem::path> files);

}  // namespace interleaf
