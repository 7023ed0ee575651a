// The help over the view: every shortcut, and every action of the mouse.
#pragma once

#include <span>

#include "ui/panels/menu_bar.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// Shows \p entries in the middle of \p area.
/// \return whether the user has closed the help
bool help_overlay(std::span<const MenuEntry> entries, const Rect& area);

}  // namespace interleaf
