// The commands of the Blend menu, and what the sliders of the weights do. What drives and the weights belong to the
// session: they are not steps of the document, so they are not undone. The kind of blend belongs to the family.
#pragma once

#include <cstddef>

#include "app/document/viewer_state.h"

namespace interleaf {

/// Lets \p driver drive, if it can. A single key is the selected one, otherwise the one with the largest weight.
void choose_driver(ViewerState& state, Driver driver, double now);

/// Takes \p key into the blend with weight 0, or out of it. The weights then drive.
void toggle_key(ViewerState& state, std::size_t key, double now);

/// Divides the weights by their sum, if it is not 0. The weights then drive.
void make_weights_sum_to_one(ViewerState& state, double now);

/// Returns to the weights before the first slider moved.
void reset_weights(ViewerState& state, double now);

/// An undoable step of the document.
void choose_blend(ViewerState& state, BlendKind blend, double now);

/// From straight to turning, and back.
void toggle_turning(ViewerState& state, double now);
bool is_turning(const ViewerState& state);

bool can_make_weights_sum_to_one(const ViewerState& state);
bool can_reset_weights(const ViewerState& state);

}  // namespace interleaf
