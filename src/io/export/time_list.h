// A text file of times at which a series is written.
#pragma once

#include <filesystem>
#include <vector>

namespace interleaf {

/// The numbers in \p file, separated by spaces, commas or ends of lines. A '#' begins a comment to the end of the
/// line.
/// \throw InputError   naming the line, if a word is no number, if a time is not above the one before, or if there
///                     are no times
/// \throw MachineError if the file cannot be opened or read
std::vector<double> read_times(const std::filesystem::path& file);

}  // namespace interleaf
