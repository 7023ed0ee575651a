// The keys that are measured: spheres over the icosahedron's 20 triangles.
#pragma once

#include <cstdint>

#include "hierarchy/hierarchy.h"

namespace interleaf::bench {

/// A key of \p leaves leaves, but for closure, refined at random all over: keys of different seeds share most
/// of their nodes.
Hierarchy random_key(Index leaves, std::uint64_t seed);

/// The same, refined around one of the icosahedron's vertices, \p place from 0 to 11: keys of different
/// places share few nodes.
Hierarchy local_key(Index leaves, std::size_t place);

}  // namespace interleaf::bench
