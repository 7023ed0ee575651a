// The field that the picture shows: whether there is one, and on what scale.
#pragma once

#include <span>

#include "family/family_fields.h"
#include "render/display.h"

namespace interleaf {

/// \throw UsageError if \p display is to show a field that is not among \p fields, naming those there are
void require_field(const Display& display, std::span<const FamilyField> fields);

/// The field that \p display shows; null where it shows none.
const FamilyField* shown_field(const Display& display, std::span<const FamilyField> fields);

/// Adapts \p display to a family with \p fields: it names one of them, the first if it named none, and
/// colors plainly where there are none; a range that is not locked is that of all keys.
void adapt_display(Display& display, std::span<const FamilyField> fields);

}  // namespace interleaf
