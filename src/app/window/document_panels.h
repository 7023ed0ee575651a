// The panels that show the document and edit it: keys, parameter domain, timeline. What a person does in them
// becomes a step of the document or moves the session.
#pragma once

#include <vector>

#include "app/document/viewer_state.h"
#include "app/pictures/key_portraits.h"
#include "app/window/commands.h"
#include "ui/panels/keys_panel.h"
#include "ui/panels/menu_bar.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// The list of keys, at most \p height high, in the present panel.
KeysPanelResult show_keys(ViewerState& state, const std::vector<KeyPortrait>& portraits, float height,
                          double now);

/// The parameter domain in the present panel. \return the pixels of its bounding box
/// \pre the family has one
Rect show_domain(ViewerState& state, double now);

/// The timeline in \p rect. \return its track
/// \pre the family has one
Rect show_timeline(ViewerState& state, const Rect& rect, double now);

/// \p command as an entry of a menu.
MenuEntry menu_entry(const Command& command, const ViewerState& state);

}  // namespace interleaf
