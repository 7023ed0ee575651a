// The extent of all keys of a family: what a camera views, so that it need not move while the keys morph.
#pragma once

#include "family/family.h"
#include "hierarchy/measure.h"

namespace interleaf {

Extent extent(const Family& family);

}  // namespace interleaf
