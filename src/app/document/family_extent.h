// The extent of all keys of a family. A camera that shows it need not move while the keys morph.
#pragma once

#include "family/family.h"
#include "hierarchy/measure.h"

namespace interleaf {

Extent extent(const Family& family);

}  // namespace interleaf
