// The menu bar along the top of the window.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace interleaf {

struct MenuEntry {
    std::string_view menu;
    std::string name;
    std::string shortcut;
    std::string_view description;
    bool on = false;
    bool enabled = true;
};

/// A submenu of \p menu, behind its entry \p after.
struct Submenu {
    std::string_view menu;
    std::string_view after;
    std::string name;
    std::vector<std::string> items;
};

struct MenuBarResult {
    std::optional<std::size_t> chosen;       ///< index of an entry
    std::optional<std::size_t> chosen_item;  ///< index of an item of the submenu
};

/// Height of the menu bar, in screen coordinates.
/// \pre a frame has begun
float menu_bar_height();

/// \param entries  the entries of one menu follow each other
/// \param title  title of the open document, shown at the right
/// \param opens  whether the first menu is to open
MenuBarResult menu_bar(std::span<const MenuEntry> entries, const Submenu& submenu, std::string_view title,
                       bool opens = false);

/// Shows entries as a context menu.
/// \return the index of the chosen entry
/// \pre a popup has begun
std::optional<std::size_t> menu_entries(std::span<const MenuEntry> entries);

}  // namespace interleaf
