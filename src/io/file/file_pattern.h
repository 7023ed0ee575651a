// Names of files: a pattern such as flow.*.obj for several, numbered series, and the extension.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace interleaf {

/// Whether \p files are a numbered series: the same but for the numbers in them, like flow.2 and flow.10.
bool is_numbered_series(const std::vector<std::filesystem::path>& files);

/// Puts \p files in their natural order (text/natural_order.h).
void sort_naturally(std::vector<std::filesystem::path>& files);

/// The files that \p path stands for, in their natural order. An asterisk in its last component stands for
/// any characters, but for no dot at the beginning. A path without, or of something that exists, stands for
/// itself.
/// \throw InputError   if nothing matches a pattern, or there is an asterisk in another component
/// \throw MachineError if the folder cannot be read
std::vector<std::filesystem::path> matching_files(const std::filesystem::path& path);

/// The extension of \p file in small letters: ".ILH" as ".ilh".
std::string lower_case_extension(const std::filesystem::path& file);

}  // namespace interleaf
