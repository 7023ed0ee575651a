// Hierarchy files (.ilh): one key, binary, little endian. docs/file-formats.md gives the layout byte by byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// Reads a key. Nothing is trusted: counts are held against the size of the file before memory is asked for,
/// and what was read has passed check(). \throw InputError   naming the file, the place and what was expected
/// \throw MachineError when the file cannot be opened or read for another reason than its content
Hierarchy read_hierarchy(const std::filesystem::path& file);

/// The same from bytes in memory; \p name stands for the file in messages.
Hierarchy parse_hierarchy(std::span<const std::byte> bytes, std::string_view name);

/// The bytes of the file.
std::vector<std::byte> serialize_hierarchy(const Hierarchy& hierarchy);

/// Writes a key whole or not at all (safe_write.h).
/// \throw MachineError when it cannot be written
void write_hierarchy(const Hierarchy& hierarchy, const std::filesystem::path& file);

}  // namespace interleaf
