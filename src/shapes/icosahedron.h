// The icosahedron on the unit sphere: the root complex of the keys of the paper's figure 8.
//
// It stands so that each coordinate plane mirrors it. The marking is compatible and unchanged by a half turn
// about each axis, so a key with these symmetries is bisected with them, too.
#pragma once

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// The icosahedron's 20 triangles, not bisected, counter-clockwise seen from outside.
Hierarchy icosahedron();

}  // namespace interleaf
