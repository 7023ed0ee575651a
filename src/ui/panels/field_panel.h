// The part of the display panel for a field: the choice of the field, its colors and their legend.
#pragma once

#include <span>
#include <string_view>

#include "family/family_fields.h"
#include "render/display.h"

namespace interleaf {

/// Offers \p fields, color maps and ranges, and shows the legend.
/// \param key_without  name of an active key that lacks the chosen field, so that the surface cannot show it;
///     empty if there is none
/// \param can_rise  whether to offer to raise the surface by the field, as flat ones can be
/// \param asks_for_unit  becomes true if the user wants to type the unit of the field
/// \return the display that the user wants: \p shown with any changes
Display field_panel(const Display& shown, std::span<const FamilyField> fields, std::string_view key_without,
                    bool can_rise, bool& asks_for_unit);

}  // namespace interleaf
