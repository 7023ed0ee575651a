// A key without its levels below a given one: for pictures that are too small to show them.
#pragma once

#include <cstddef>

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// \p key with every node at \p level as a leaf, and without fields. It takes one walk over the nodes.
///
/// Under a compatible marking the result conforms, because both sides of an edge reach it at the same level.
/// Otherwise leaves may hang at edges of the roots.
Hierarchy cut_at_level(const Hierarchy& key, unsigned level);

/// The deepest level at which cut_at_level() leaves at most \p max_leaves leaves; 0 if there are more roots.
unsigned level_with_at_most(const Hierarchy& key, std::size_t max_leaves);

}  // namespace interleaf
