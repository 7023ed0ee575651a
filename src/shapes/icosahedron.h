// The icosahedron on the unit sphere: the root complex of the keys of the paper's figure 8.
//
// Each coordinate plane is a mirror plane of it. The marking is compatible, and a half turn about any axis
// does not change it, so a key with these symmetries is also bisected symmetrically.
#pragma once

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// The icosahedron's 20 triangles, unrefined, counter-clockwise seen from outside.
Hierarchy icosahedron();

}  // namespace interleaf
