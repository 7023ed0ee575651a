// Area, volume and leaves of the blend over time, as plots below the timeline, on its scale.
#pragma once

#include <vector>

#include "ui/timeline/time_scale.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// The figures of the blend at a time.
struct BlendSample {
    double time;
    double area;    ///< in squared units of the positions
    double volume;  ///< enclosed, in cubed units; of closed surfaces
    double leaves;
};

/// Times ascending.
using BlendCurves = std::vector<BlendSample>;

/// Height of the plots at scale 1, with the gap above them.
inline constexpr float blend_plots_height = 3 * 30 + 4;

/// Shows the plots in \p area, as far as they are measured, with a line at \p time. The pointer reads the figures.
/// \param scale  has the width of \p area
void blend_plots(const Rect& area, const TimeScale& scale, const BlendCurves& curves, double time);

}  // namespace interleaf
