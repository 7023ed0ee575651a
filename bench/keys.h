// The measured keys: spheres over the icosahedron's 20 triangles.
#pragma once

#include <cstdint>

#include "hierarchy/hierarchy.h"

namespace interleaf::bench {

/// A key refined at random all over, with \p leaves leaves plus those of closure. Keys with different seeds
/// share most of their nodes.
Hierarchy random_key(Index leaves, std::uint64_t seed);

/// A key refined around one of the icosahedron's vertices, with \p leaves leaves plus those of closure. Keys
/// with different places share few nodes.
/// \param place  0 to 11
Hierarchy local_key(Index leaves, std::size_t place);

}  // namespace interleaf::bench
