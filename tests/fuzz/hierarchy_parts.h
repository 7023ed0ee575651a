// What the targets of both forms of hierarchy files have in common.
#pragma once

#include "fuzz/target.h"

#include "io/hierarchy_format.h"

namespace interleaf::fuzz {

Inspection read_hierarchy_bytes(ByteSpan file);

/// The header that \p file begins with.
/// \pre  file has at least the 32 bytes of a header
hierarchy_format::Header header_at(ByteSpan file);

/// Ends \p bytes with their checksum.
void append_checksum(Bytes& bytes);

/// Takes \p size bytes off the front of \p rest, or all that there are.
Bytes take(ByteSpan& rest, std::uint64_t size);

void append(Bytes& bytes, ByteSpan more);

}  // namespace interleaf::fuzz
