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

/// The files that \p path stands for, in their natural order. An asterisk in the last component stands for
/// any characters, except for a dot at the beginning. A path without an asterisk stands for itself, as does
/// the path of an existing file or folder.
/// \throw InputError   if no file matches a pattern, or if another component has an asterisk
/// \throw MachineError if the folder cannot be read
std::vector<std::filesystem::path> matching_files(const std::filesystem::path& path);

/// The one path that stands for \p files as matching_files() does: a pattern that matches them and no others, in this
/// order; the first of them if there is no such pattern, or if it is the only one.
/// \pre there is a file
std::filesystem::path path_of_all(const std::vector<std::filesystem::path>& files);

/// The extension of \p file in lower case: ".ILH" becomes ".ilh".
std::string lower_case_extension(const std::filesystem::path& file);

}  // namespace interleaf
