// The field that the picture shows, if any, and the scale of its colors.
#pragma once

#include <optional>
#include <span>

#include "family/family_fields.h"
#include "family/vector_field.h"
#include "family/warp.h"
#include "hierarchy/measure.h"
#include "render/display.h"

namespace interleaf {

/// Checks that \p fields have the field that \p display shows, and those that raise it and give it arrows.
/// \throw UsageError naming the option and the existing fields if a field is not among \p fields; or if the ends of the
///                   wanted range, as floats, do not ascend
void require_field(const Display& display, std::span<const FamilyField> fields);

/// The field that \p display shows; null if it shows none.
const FamilyField* shown_field(const Display& display, std::span<const FamilyField> fields);

/// Adapts \p display to a family with \p fields. If \p display names none of them, it names the first.
/// Without fields, it shows the plain color. The scale gets the wanted range, if
/// any; else an unlocked range becomes the range over all keys.
void adapt_display(Display& display, std::span<const FamilyField> fields);

/// The warp by the shown scalar, or by another one, that \p display asks for; none if the keys are not flat.
/// \param box  of all keys
std::optional<Warp> warp_of(const Display& display, std::span<const FamilyField> fields, const Box& box);

/// The vector whose arrows \p display asks for; none if \p fields lack it.
std::optional<VectorField> shown_vector(const Display& display, std::span<const FamilyField> fields);

/// Makes \p display show the first scalar of \p fields, if there is one.
void color_by_field(Display& display, std::span<const FamilyField> fields);

}  // namespace interleaf
