// Hierarchy files (.ilh): one key, binary, little endian, plain or compressed. docs/file-formats.md describes
// both layouts byte by byte.
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
    /// Whether to write the compressed form. It has the same content, to the last bit, and at most a third of
    /// the plain form's bytes where the surface is smooth.
    bool compressed = false;

    /// The number of bits to which each coordinate is rounded, relative to the longest side of the bounding
    /// box: 8 to 24, or 0 for no rounding. A coordinate moves by at most side / 2^(rounding_bits + 1).
    unsigned rounding_bits = 0;
};

/// Reads a key of either form. The reader trusts nothing: it compares counts with the size of the file before
/// it allocates memory, and the result has passed check().
/// \throw InputError   naming the file, the place and what was expected
/// \throw MachineError if the file cannot be opened, or cannot be read for a reason other than its content
Hierarchy read_hierarchy(const std::filesystem::path& file);

/// Reads a key from bytes in memory. Messages call the file \p name.
Hierarchy parse_hierarchy(std::span<const std::byte> bytes, std::string_view name);

/// Whether the header of \p file says that the file has the compressed form. Checks nothing after the header.
/// \throw InputError, MachineError as read_hierarchy(), if \p file is not a hierarchy file
bool is_compressed_hierarchy(const std::filesystem::path& file);

/// The bytes of the file that write_hierarchy() writes.
std::vector<std::byte> serialize_hierarchy(const Hierarchy& hierarchy,
                                           const HierarchyFileOptions& options = {});

/// Writes a key whole or not at all (safe_write.h).
/// \throw MachineError if the file cannot be written
void write_hierarchy(const Hierarchy& hierarchy, const std::filesystem::path& file,
                     const HierarchyFileOptions& options = {});

}  // namespace interleaf
