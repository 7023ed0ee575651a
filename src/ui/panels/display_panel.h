// The display panel: shading, lines, and coloring with its legend.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "family/family_fields.h"
#include "render/display.h"
#include "render/palette.h"

namespace interleaf {

/// What the legend explains.
struct Legend {
    LevelRange levels;
    std::span<const KeySet> origins;  ///< that occur
    std::span<const std::size_t>
        active_keys;  ///< the keys that the bits of origins mean, as indices of the family
    std::span<const std::string> active_names;     ///< of these, in their order
    std::span<const FamilyField> fields;           ///< of the family
    std::optional<std::string> key_without_field;  ///< an active key that lacks the one that is shown
};

/// \return what the person wants to be shown: \p shown with any changes
Display display_panel(const Display& shown, const Legend& legend);

}  // namespace interleaf
