// The part of the display panel for a field: which one, its colors, and what they mean.
#pragma once

#include <span>
#include <string_view>

#include "family/family_fields.h"
#include "render/display.h"

namespace interleaf {

/// Chooses among \p fields, color maps and ranges, and shows the legend. \p key_without names an active key
/// that lacks the chosen field, so that the surface cannot show it; empty for none.
void field_panel(Display& display, std::span<const FamilyField> fields, std::string_view key_without);

}  // namespace interleaf
