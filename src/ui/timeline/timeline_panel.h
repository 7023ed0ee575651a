// The timeline: playback, the time to scrub, the keys as marks, and the weights as curves.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "family/family.h"
#include "family/playback.h"
#include "ui/timeline/blend_plots.h"
#include "ui/timeline/timeline_track.h"
#include "ui/timeline/transport.h"
#include "ui/timeline/weight_curves.h"
#include "ui/widgets/rect.h"

namespace interleaf {

struct TimelineState {
    TransportState transport;
    bool drives;                            ///< whether the surface follows the time
    std::string_view remark;                ///< why it does not
    std::optional<TimeRange> range = {};    ///< the in and out points
    std::optional<TimeRange> visible = {};  ///< the times that are shown; none for all
    std::optional<TimeDrag> drag = {};      ///< the last result's
    std::span<const WeightCurve> curves = {};
    const BlendCurves* plots = nullptr;  ///< shown below the curves; null for none
    const Weights& weights;              ///< at the present time
};

struct TimelineResult {
    TransportResult transport;
    TrackResult track;
    Rect area;  ///< of the track, from the first to the last visible time
};

/// \pre has_source(family, state.transport.source)
TimelineResult timeline_panel(const Rect& rect, const Family& family, const TimelineState& state);

/// The times that the panel shows of \p whole.
/// \param wanted  none for all
TimeRange shown_times(TimeRange whole, const std::optional<TimeRange>& wanted);

/// Number of samples of the curves in a panel that is \p width wide.
std::size_t curve_samples(float width);

}  // namespace interleaf
