// Writing a file whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace interleaf {

/// Writes \p bytes to a temporary file beside \p file, flushes it to the disk and renames it over \p file:
/// whatever happens, what is called \p file afterwards is the old content or the new one, whole. An existing
/// file's permissions are kept, and its owner as far as we may; one that may not be written is left as it is.
/// A symbolic link is followed, other hard links keep the old content. What is neither a file nor a folder,
/// /dev/null say, is written to as it is. \throw MachineError naming the file, and what the system said
void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace interleaf
