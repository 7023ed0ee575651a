// `interleaf check`: the invariants of keys and constraints (B) of families (paper, section 3.2).
#pragma once

#include <filesystem>
#include <span>

namespace interleaf {

/// Prints a line for each of \p files, each as open_family() takes it: on standard output when it is sound,
/// with a line more for each key whose roots had to be renumbered or marked anew; else, with every violation,
/// on standard error. \return whether all \p files are sound \throw MachineError when a file cannot be read
bool run_check(std::span<const std::filesystem::path> files);

}  // namespace interleaf
