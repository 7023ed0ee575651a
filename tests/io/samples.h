// Hierarchies and families to write and read.
#pragma once

#include <random>

#include "family/family.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

/// An octahedron, open if \p open (one triangle missing), with random leaves bisected \p rounds times.
Hierarchy random_hierarchy(std::mt19937& random, bool open, int rounds);

/// Three keys over the octahedron, a timeline, a domain, and names that need escaping.
Family sample_family(std::mt19937& random);

/// \p hierarchy with \p count random fields of random kinds.
Hierarchy with_fields(Hierarchy hierarchy, std::mt19937& random, std::size_t count);

/// Whether all that a file holds is equal, floats by their bits.
bool is_same(const Hierarchy& a, const Hierarchy& b);
bool is_same(const Family& a, const Family& b);

}  // namespace interleaf
