// Random damage to a file: cut, grown, flipped or swapped bytes, with or without repaired checksums and
// counts.
#pragma once

#include <random>

#include "fuzz/target.h"

namespace interleaf::fuzz {

/// \p file with one to three random changes, in one of its parts or in the whole file.
Bytes mutated(ByteSpan file, std::mt19937& random);

}  // namespace interleaf::fuzz
