// The list of a family's keys. The user chooses keys in it, and drags them elsewhere.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "family/weights.h"
#include "ui/panels/key_search.h"
#include "ui/panels/menu_bar.h"
#include "ui/widgets/rect.h"

namespace interleaf {

struct KeyRow {
    std::string name;
    std::size_t leaves;
    unsigned deepest;  ///< level of the deepest leaf
    unsigned picture;  ///< OpenGL texture; 0 if there is none yet
};

struct KeysPanel {
    std::span<const KeyRow> keys;
    const Weights& weights;  ///< the list highlights the active keys
    std::optional<std::size_t> selected;
    std::span<const MenuEntry> menu;  ///< context menu of the selected key
    const KeySearch& search;
    bool takes_focus = false;  ///< whether the search field takes the keyboard
};

struct KeysPanelResult {
    Rect list;                              ///< rectangle of the visible rows
    std::vector<std::size_t> visible;       ///< the keys whose rows are visible
    std::optional<std::size_t> chosen;      ///< clicked key
    std::optional<std::size_t> toggled;     ///< key clicked with Ctrl: into the blend, or out of it
    std::optional<std::size_t> renamed;     ///< double-clicked key
    std::optional<std::size_t> dragged;     ///< key dropped on another key
    std::size_t dropped_on = 0;             ///< that other key
    std::optional<KeySearch> search;        ///< the new search, if the user has changed it
    std::optional<std::size_t> menu_entry;  ///< chosen from the context menu
    bool add = false;                       ///< add keys from files
    bool keep_blend = false;
};

/// \param height  maximum height of the list; a longer list scrolls
KeysPanelResult keys_panel(const KeysPanel& panel, float height);

/// Side of a key's picture, in screen coordinates.
float key_picture_side();

/// Accepts a key that is dragged from the list and dropped on the last item.
/// \return the index of the key, below \p key_count; none if no key was dropped
std::optional<std::size_t> dropped_key(std::size_t key_count);

}  // namespace interleaf
