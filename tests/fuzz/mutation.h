// Random damage to a file: cut, grown, flipped, swapped, with checksums and counts repaired or not.
#pragma once

#include <random>

#include "fuzz/target.h"

namespace interleaf::fuzz {

/// \p file with one to three random changes, in one of its parts or as a whole.
Bytes mutated(ByteSpan file, std::mt19937& random);

}  // namespace interleaf::fuzz
