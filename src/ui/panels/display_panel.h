// The display panel: shading, lines, and coloring with its legend.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "family/family_fields.h"
#include "render/color_map.h"
#include "render/display.h"
#include "render/palette.h"
#include "ui/panels/field_curves.h"

namespace interleaf {

/// What the legend explains.
struct Legend {
    LevelRange levels;
    std::span<const KeySet> origins;            ///< all origins that occur
    std::span<const std::size_t> active_keys;   ///< keys of the bits in origins, as indices into the family
    std::span<const std::string> active_names;  ///< names of the active keys, in the same order
    std::span<const FamilyField> fields;        ///< fields of the family
    std::optional<std::string> key_without_field;  ///< an active key that lacks the shown field; may be none
    const FieldCurves* curves = nullptr;           ///< of the shown scalar over time; null for none
    double time = 0;
    ColorScale measured;                ///< of a coloring by values that the blend determines
    Shading shading = Shading::smooth;  ///< of the surface
    bool is_flat = false;               ///< whether the keys lie in a plane, so that a field can raise them
};

struct DisplayPanelResult {
    Display display;             ///< that the user wants: the shown one with any changes
    bool asks_for_unit = false;  ///< the user wants to type the unit of the shown field
};

DisplayPanelResult display_panel(const Display& shown, const Legend& legend);

}  // namespace interleaf
