// The weights of the keys as curves over the time of a timeline or of a path.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "family/family.h"
#include "family/weights.h"
#include "ui/timeline/time_scale.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// A time without interruption in which a key is active.
struct WeightCurve {
    struct Point {
        double time;
        double weight;
    };
    std::size_t key;
    std::vector<Point> points;  ///< times ascending
};

/// The curves between the times of \p visible, sampled at about \p sample_count times and at all keys, or at all
/// points of the path.
/// \pre has_source(family, source)
std::vector<WeightCurve> weight_curves(const Family& family, TimeSource source, TimeRange visible,
                                       std::size_t sample_count);

/// Draws \p curves into \p area in the colors of their keys, with 0 and 1 as lines, and a dot for each
/// present weight.
/// \param scale    has the width of \p area
/// \param weights  at \p time; empty for none
void draw_weight_curves(const Rect& area, const TimeScale& scale, std::span<const WeightCurve> curves,
                        double time, const Weights& weights);

}  // namespace interleaf
