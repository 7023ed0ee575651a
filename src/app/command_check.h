// `interleaf check`: the invariants of keys and constraints (B) of families (paper, section 3.2).
#pragma once

#include <filesystem>
#include <span>

namespace interleaf {

/// Prints a line for each of \p files: on standard output when it is sound, else, with every violation, on
/// standard error.
/// \return whether all \p files are sound
/// \throw MachineError when a file cannot be read
bool run_check(std::span<const std::filesystem::path> files);

}  // namespace interleaf
