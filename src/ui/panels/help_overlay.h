// The help: every shortcut and what the mouse does, over the view.
#pragma once

#include <span>

#include "ui/panels/menu_bar.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// Shows \p entries in the middle of \p area.
/// \return whether the person has closed it
bool help_overlay(std::span<const MenuEntry> entries, const Rect& area);

}  // namespace interleaf
