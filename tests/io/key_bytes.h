// The bytes of a hierarchy file of either form, to damage and to read again.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

constexpr HierarchyFileOptions compressed_form{.compressed = true, .rounding_bits = 0};

using Bytes = std::vector<std::byte>;

/// Makes the checksum at the end fit what stands before it.
void repair_checksum(Bytes& bytes);

/// What parse_hierarchy() says of \p bytes, called "key.ilh"; empty if it takes them.
std::string error_of(const Bytes& bytes);

/// Checks that error_of() finds a random change of each single byte of \p whole.
void check_damage_is_found(const Bytes& whole);

/// Refused with an error that names the file, or a sound hierarchy. \return whether it is one
bool is_sound_or_refused(const Bytes& bytes);

}  // namespace interleaf
