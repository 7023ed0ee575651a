#include "hierarchy/detail/detail_levels.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace interleaf {

std::vector<DetailLevel> detail_levels(const CutSizes& sizes, double growth) {
    assert(growth > 1);
    constexpr float roots_alone = std::numeric_limits<float>::infinity();
    const std::size_t all = sizes.leaf_count(keep_everything);
    std::vector<DetailLevel> levels = {
        {roots_alone, sizes.leaf_count(roots_alone), sizes.distance(roots_alone)}};
    for (double target = static_cast<double>(levels[0].leaves) * growth; target < static_cast<double>(all);
         target *= growth) {
        const float threshold = sizes.threshold(static_cast<std::size_t>(target));
        const std::size_t leaves = sizes.leaf_count(threshold);
        if (leaves > levels.back().leaves) levels.push_back({threshold, leaves, sizes.distance(threshold)});
    }
    if (all > levels.back().leaves) levels.push_back({keep_everything, all, 0});
    return levels;
}

DetailPlace detail_place(std::size_t level_count, double detail) {
    assert(level_count > 0);
    if (level_count == 1) return {0, 0, 0};
    const double place = std::clamp(detail, 0.0, 1.0) * static_cast<double>(level_count - 1);
    const std::size_t coarse = std::min(static_cast<std::size_t>(place), level_count - 2);
    return {coarse, coarse + 1, static_cast<float>(place - static_cast<double>(coarse))};
}

}  // namespace interleaf
