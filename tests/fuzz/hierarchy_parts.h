// What the targets of both forms of hierarchy files have in common.
#pragma once

#include "fuzz/target.h"

#include "io/hierarchy/hierarchy_format.h"

namespace interleaf::fuzz {

Inspection read_hierarchy_bytes(ByteSpan file);

/// The header that \p file begins with.
/// \pre  file has at least the 32 bytes of a header
hierarchy_format::Header header_at(ByteSpan file);

/// A table of per-vertex fields: for each a byte for its kind, which is the number of its components, one for
/// the length of its name, the name.
struct FieldTable {
    std::uint64_t size = 0;  ///< bytes of whole entries
    std::uint32_t fields = 0;
    std::uint64_t components = 0;  ///< of all fields
};

/// The first entries of \p bytes, at most \p max_fields.
FieldTable field_table(ByteSpan bytes, std::uint32_t max_fields);

/// Bytes of the plain file with the counts of \p header and fields of \p components components, without the
/// table.
std::uint64_t plain_file_size(const hierarchy_format::Header& header, std::uint64_t components);

/// Ends \p bytes with their checksum.
void append_checksum(Bytes& bytes);

/// Takes \p size bytes off the front of \p rest, or all that there are.
Bytes take(ByteSpan& rest, std::uint64_t size);

void append(Bytes& bytes, ByteSpan more);

}  // namespace interleaf::fuzz
