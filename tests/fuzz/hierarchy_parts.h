// Functions that the targets of both forms of hierarchy files share.
#pragma once

#include "fuzz/target.h"

#include "io/hierarchy/hierarchy_format.h"

namespace interleaf::fuzz {

Inspection read_hierarchy_bytes(ByteSpan file);

/// The header at the beginning of \p file.
/// \pre \p file has at least the 32 bytes of a header
hierarchy_format::Header header_at(ByteSpan file);

/// A table of fields. Each field has one byte for its kind, which is the number of its components, one byte
/// for the length of its name, and the name.
struct FieldTable {
    std::uint64_t size = 0;  ///< bytes of complete entries
    std::uint32_t fields = 0;
    std::uint64_t components = 0;  ///< of all fields
};

/// The first entries in \p bytes, at most \p max_fields.
FieldTable field_table(ByteSpan bytes, std::uint32_t max_fields);

/// The number of bytes of the plain file, without the field table, for the counts of \p header and fields of
/// \p components components.
std::uint64_t plain_file_size(const hierarchy_format::Header& header, std::uint64_t components);

/// Appends the checksum of \p bytes.
void append_checksum(Bytes& bytes);

/// Removes \p size bytes, or all if there are fewer, from the front of \p rest.
Bytes take(ByteSpan& rest, std::uint64_t size);

void append(Bytes& bytes, ByteSpan more);

}  // namespace interleaf::fuzz
