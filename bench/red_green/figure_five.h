// The paper's figure 5 as a drawing: two keys of six flat triangles around a vertex, refined in different
// places, and the union that they need, with 4-1 splits and with bisection.
#pragma once

#include <vector>

#include "picture_family.h"

namespace interleaf::bench {

/// In two rows, 4-1 splits above, bisection below: the first key, the union, the second key.
std::vector<PicturePiece> figure_five();

}  // namespace interleaf::bench
