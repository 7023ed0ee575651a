#include "app/document/shown_field.h"

#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {
namespace {

/// Keeps the range of shown values under another offset.
void move_offset(ColorScale& scale, double offset) {
    if (offset == scale.offset) return;
    const double moved = scale.offset - offset;
    scale.range = {static_cast<float>(double{scale.range.min} + moved),
                   static_cast<float>(double{scale.range.max} + moved)};
}

}  // namespace

void require_field(const Display& display, std::span<const FamilyField> fields) {
    if (display.coloring != Coloring::field || find_field(fields, display.field) != nullptr) return;
    std::string known;
    for (const FamilyField& field : fields) known += (known.empty() ? "" : ", ") + field.label.name;
    if (known.empty())
        throw UsageError(fmt::format(
            "--color: expected plain, level, origin or checker, got '{}'; the keys have no fields",
            display.field));
    throw UsageError(fmt::format("--color: no field is called '{}'; there are {}", display.field, known));
}

const FamilyField* shown_field(const Display& display, std::span<const FamilyField> fields) {
    return display.coloring == Coloring::field ? find_field(fields, display.field) : nullptr;
}

std::optional<Warp> warp_of(const Display& display, std::span<const FamilyField> fields, const Box& box) {
    const FamilyField* const field = shown_field(display, fields);
    const std::optional<unsigned> axis = flat_axis(box);
    if (!axis || !(display.height > 0) || field == nullptr || field->label.kind != FieldKind::scalar ||
        !(field->max > field->min))
        return std::nullopt;
    const glm::vec3 size = box.max - box.min;
    return Warp{.axis = *axis,
                .field = field->label.name,
                .factor = display.height * std::max({size.x, size.y, size.z}) / (field->max - field->min),
                .zero = field->min};
}

void color_by_field(Display& display, std::span<const FamilyField> fields) {
    const auto is_scalar = [](const FamilyField& field) { return field.label.kind == FieldKind::scalar; };
    const auto first = std::ranges::find_if(fields, is_scalar);
    if (first == fields.end()) return;
    display.coloring = Coloring::field;
    display.field = first->label.name;
}

void adapt_display(Display& display, std::span<const FamilyField> fields) {
    if (fields.empty()) {
        if (display.coloring == Coloring::field) display.coloring = Coloring::plain;
        display.field.clear();
        return;
    }
    if (find_field(fields, display.field) == nullptr) display.field = fields.front().label.name;
    const FamilyField& field = *find_field(fields, display.field);
    if (field.label.kind != FieldKind::scalar) return;
    if (display.range_locked) move_offset(display.scale, field.offset);
    else display.scale.range = {field.min, field.max};
    display.scale.offset = field.offset;
}

}  // namespace interleaf
