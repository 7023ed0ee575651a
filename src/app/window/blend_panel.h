// The weights panel of the document: what drives the blend, and the sliders of the weights.
#pragma once

#include <optional>

#include "app/document/viewer_state.h"
#include "family/weights.h"

namespace interleaf {

struct BlendActions {
    std::optional<Driver> driver;    ///< the chosen one
    std::optional<Weights> weights;  ///< set by hand
    bool resets = false;             ///< the weights before the first slider moved are wanted
};

/// Shows the panel in the present window.
BlendActions show_blend(const ViewerState& state);

void apply_to_blend(const BlendActions& done, ViewerState& state, double now);

}  // namespace interleaf
