// The help over the view: every action of the mouse and every shortcut, with a search.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "ui/panels/menu_bar.h"
#include "ui/widgets/rect.h"

namespace interleaf {

struct HelpOverlay {
    std::span<const MenuEntry> entries;
    const std::string& search;  ///< only rows that match it are shown
    bool takes_focus = false;   ///< whether the search field takes the keyboard
};

struct HelpResult {
    bool closed = false;
    std::optional<std::string> search;  ///< the new one, if the user has changed it
};

/// Shows the help in the middle of \p area.
HelpResult help_overlay(const HelpOverlay& help, const Rect& area);

}  // namespace interleaf
