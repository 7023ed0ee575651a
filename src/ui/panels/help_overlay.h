// The help: every key and what the mouse does, over the view.
#pragma once

#include <span>

#include "ui/panels/menu_bar.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// Shows \p entries in the middle of \p area; clears \p shown when it is closed.
void help_overlay(std::span<const MenuEntry> entries, const Rect& area, bool& shown);

}  // namespace interleaf
