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

void require_scalar_for(const char* option, const std::string& name, std::span<const FamilyField> fields) {
    std::string known;
    for (const FamilyField& field : fields) {
        if (field.label.kind != FieldKind::scalar) continue;
        if (field.label.name == name) return;
        known += (known.empty() ? "" : ", ") + field.label.name;
    }
    throw UsageError(fmt::format("{}: no scalar field is called '{}'; {}", option, name,
                                 known.empty() ? "the keys have none" : "there are " + known));
}

}  // namespace

void require_field(const Display& display, std::span<const FamilyField> fields) {
    if (!display.raised_by.empty()) require_scalar_for("--height", display.raised_by, fields);
    for (const std::string& part : display.arrow_parts)
        if (!part.empty()) require_scalar_for("--arrows", part, fields);
    if (display.coloring != Coloring::field || find_field(fields, display.field) != nullptr) return;
    std::string known;
    for (const FamilyField& field : fields) known += (known.empty() ? "" : ", ") + field.label.name;
    if (known.empty())
        throw UsageError(fmt::format("--color: expected {}, got '{}'; the keys have no fields",
                                     coloring_names_in_words(), display.field));
    throw UsageError(fmt::format("--color: no field is called '{}'; there are {}", display.field, known));
}

const FamilyField* shown_field(const Display& display, std::span<const FamilyField> fields) {
    return display.coloring == Coloring::field ? find_field(fields, display.field) : nullptr;
}

std::optional<Warp> warp_of(const Display& display, std::span<const FamilyField> fields, const Box& box) {
    const FamilyField* const field =
        display.raised_by.empty() ? shown_field(display, fields) : find_field(fields, display.raised_by);
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

std::optional<VectorField> shown_vector(const Display& display, std::span<const FamilyField> fields) {
    if (!display.arrows) return std::nullopt;
    if (!display.arrow_parts[0].empty()) return vector_of_parts(fields, display.arrow_parts);
    const FamilyField* const field = shown_field(display, fields);
    return field != nullptr ? vector_of(fields, field->label.name) : std::nullopt;
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
    if (display.range_locked)
        move_offset(display.scale, field.offset);
    else
        display.scale.range = {field.min, field.max};
    display.scale.offset = field.offset;
}

}  // namespace interleaf
