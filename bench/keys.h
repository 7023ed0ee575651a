// The keys that are measured: spheres over the icosahedron's 20 triangles, refined towards different places.
#pragma once

#include <cstdint>

#include "hierarchy/hierarchy.h"

namespace interleaf::bench {

/// A key of about \p leaves leaves, refined at random with a density that \p seed decides, midpoints on the
/// unit sphere.
Hierarchy random_sphere_key(Index leaves, std::uint64_t seed);

}  // namespace interleaf::bench
