// Hierarchy files (.ilh): one key, binary, little endian, plain or compressed. docs/file-formats.md gives the
// layouts byte by byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// How a key is written.
struct HierarchyFileOptions {
    /// The compressed form: a third of the plain one or less where the surface is smooth, with the same
    /// content to the last bit.
    bool compressed = false;

    /// Rounds each coordinate to this many bits of the longest side of the bounding box, 8 to 24, so by at
    /// most side / 2^(rounding_bits + 1); 0: not at all.
    unsigned rounding_bits = 0;
};

/// Reads a key of either form. Nothing is trusted: counts are held against the size of the file before memory
/// is used, and what was read has passed check().
/// \throw InputError   naming the file, the place and what was expected
/// \throw MachineError when the file cannot be opened or read for another reason than its content
Hierarchy read_hierarchy(const std::filesystem::path& file);

/// The same from bytes in memory; \p name stands for the file in messages.
Hierarchy parse_hierarchy(std::span<const std::byte> bytes, std::string_view name);

/// Whether \p file says that it is of the compressed form. Nothing else of it is checked.
/// \throw InputError, MachineError as read_hierarchy() for a file that is no hierarchy file
bool is_compressed_hierarchy(const std::filesystem::path& file);

/// The bytes of the file.
std::vector<std::byte> serialize_hierarchy(const Hierarchy& hierarchy,
                                           const HierarchyFileOptions& options = {});

/// Writes a key whole or not at all (safe_write.h).
/// \throw MachineError when it cannot be written
void write_hierarchy(const Hierarchy& hierarchy, const std::filesystem::path& file,
                     const HierarchyFileOptions& options = {});

}  // namespace interleaf
