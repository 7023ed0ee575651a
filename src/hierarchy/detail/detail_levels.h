// Continuous detail: a sequence of cuts of a hierarchy, from the roots to the whole, and the morphs (geomorphs)
// between consecutive ones.
//
// Two levels of one key are keys over the same roots, so a transition between them is an interpolation
// (morph.h). Their union is the finer level, and there the coarser level is bisected at the middles of its
// edges. At both ends of a transition the morph is exactly one of the levels, so the surface changes
// continuously with the detail.
#pragma once

#include <cstddef>
#include <vector>

#include "hierarchy/detail/cut.h"

namespace interleaf {

struct DetailLevel {
    float threshold;     ///< of the cut
    std::size_t leaves;  ///< number of leaves of the cut
    float distance;      ///< CutSizes::distance() of the cut
};

/// The levels of detail of a hierarchy. The first level is the roots, the last one the whole hierarchy, and
/// each has about \p growth times the leaves of the level before. A hierarchy without bisections has one level.
/// \pre  \p growth is over 1
std::vector<DetailLevel> detail_levels(const CutSizes& sizes, double growth = 2);

/// A place between two levels: the surface (1 - blend) coarse + blend fine.
struct DetailPlace {
    std::size_t coarse;  ///< number of a level
    std::size_t fine;    ///< the next level; the same level if there is only one
    float blend;         ///< 0 to 1
};

/// The place of \p detail, a number from 0, the roots, to 1, the whole hierarchy; all transitions take equal
/// parts of it. Numbers outside go to the nearest end.
DetailPlace detail_place(std::size_t level_count, double detail);

}  // namespace interleaf
