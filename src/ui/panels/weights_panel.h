// The weights of all keys, as numbers and as bars in the keys' colors.
#pragma once

#include "family/family.h"

namespace interleaf {

void weights_panel(const Family& family, const Weights& weights);

}  // namespace interleaf
