// The menu bar along the top of the window.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace interleaf {

struct MenuEntry {
    std::string_view menu;
    std::string_view name;
    std::string shortcut;
    std::string_view description;
    bool on;
};

struct MenuBarResult {
    float height;
    std::optional<std::size_t> chosen;  ///< index of an entry
};

/// \param entries  those of one menu in a row
/// \param title    of what is open, shown at the right
MenuBarResult menu_bar(std::span<const MenuEntry> entries, std::string_view title);

}  // namespace interleaf
