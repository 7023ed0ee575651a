// The box that holds every key of a family: what a camera frames, so that it need not move while the keys
// morph.
#pragma once

#include "family/family.h"
#include "hierarchy/measure.h"

namespace interleaf {

Box bounding_box(const Family& family);

}  // namespace interleaf
