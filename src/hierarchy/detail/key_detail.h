// All that levels of detail of one key take. Measured once per key.
#pragma once

#include <vector>

#include "hierarchy/detail/bisection_forest.h"
#include "hierarchy/detail/deviation.h"
#include "hierarchy/detail/normal_cones.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

struct KeyDetail {
    BisectionForest forest{};
    std::vector<float> deviations{};  ///< by the place of the bisection
    std::vector<NormalCone> cones{};  ///< by the place of the bisection
    std::vector<float> errors{};      ///< vertex_errors(), by vertex
};

/// \pre  the hierarchy passes check()
KeyDetail measure_detail(const Hierarchy& hierarchy, const DetailProgress& progress = {});

}  // namespace interleaf
