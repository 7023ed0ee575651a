// Edits of units: of the shown field, and of time. Each asks the user first.
#pragma once

#include "app/document/viewer_state.h"

namespace interleaf {

/// The scalar whose colors the document shows; null if it shows none.
const std::string* shown_scalar(const ViewerState& state);

/// Asks for the unit of the shown scalar. Does nothing without one.
void ask_for_field_unit(ViewerState& state);

/// Asks for the unit of the timeline's times. Does nothing without a timeline.
void ask_for_time_unit(ViewerState& state);

}  // namespace interleaf
