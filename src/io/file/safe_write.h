// Writes a file whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace interleaf {

/// Writes \p bytes to a temporary file beside \p file, flushes that file to the disk and renames it over
/// \p file. So \p file always has the old content or the new content, whole, even after a kill or a power
/// failure.
///
/// The new file has the permissions of the existing file, and its owner if the system permits. A
/// write-protected file is not replaced. A symbolic link is followed; other hard links keep the old content.
/// A device, such as /dev/null, is written to directly.
/// \throw MachineError naming the file and the error of the system
void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace interleaf
