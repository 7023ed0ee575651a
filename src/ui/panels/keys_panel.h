// The list of a family's keys: choosing one, and dragging it elsewhere.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "family/weights.h"
#include "ui/panels/menu_bar.h"
#include "ui/widgets/rect.h"

namespace interleaf {

struct KeyRow {
    std::string name;
    std::size_t leaves;
    unsigned deepest;  ///< level
    unsigned picture;  ///< an OpenGL texture; 0 for none yet
};

struct KeysPanel {
    std::span<const KeyRow> keys;
    const Weights& weights;  ///< keys that are active in them stand out
    std::optional<std::size_t> selected;
    std::span<const MenuEntry> menu;  ///< for the right mouse button, about the selected key
};

struct KeysPanelResult {
    Rect list;                              ///< of the rows in sight
    std::size_t first = 0;                  ///< row in sight,
    std::size_t end = 0;                    ///< and the one behind the last
    std::optional<std::size_t> chosen;      ///< clicked
    std::optional<std::size_t> renamed;     ///< double-clicked
    std::optional<std::size_t> dragged;     ///< dropped on another row ...
    std::size_t dropped_on = 0;             ///< ... this one
    std::optional<std::size_t> menu_entry;  ///< chosen from the menu
    bool add = false;                       ///< keys from files
    bool keep_blend = false;
};

/// \param height  of the list at most; it scrolls
KeysPanelResult keys_panel(const KeysPanel& panel, float height);

/// The side of a key's picture, in screen coordinates.
float key_picture_side();

/// A key dropped on the last item after a drag from the list.
/// \return the index of the key, below \p key_count; none if no key was dropped
std::optional<std::size_t> dropped_key(std::size_t key_count);

}  // namespace interleaf
