// Functions that damage the bytes of a hierarchy file of either form, and read them again.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

constexpr HierarchyFileOptions compressed_form{.compressed = true, .rounding_bits = 0};

using Bytes = std::vector<std::byte>;

/// Replaces the checksum at the end of \p bytes by the right one.
void repair_checksum(Bytes& bytes);

/// The error of parse_hierarchy() for \p bytes, called "key.ilh"; empty if it accepts them.
std::string error_of(const Bytes& bytes);

/// Checks that error_of() finds a random change of each single byte of \p whole.
void check_damage_is_found(const Bytes& whole);

/// Checks that \p bytes are a sound hierarchy, or are rejected with an error that names the file.
/// \return whether they are a hierarchy
bool is_sound_or_refused(const Bytes& bytes);

}  // namespace interleaf
