#include "app/document/shown_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "render/surface_values.h"

namespace interleaf {
namespace {

/// The range of shown values, without the offset; none if it is not one of floats.
std::optional<ValueRange> without_offset(const std::array<double, 2>& shown, double offset) {
    constexpr double most = std::numeric_limits<float>::max();
    const double min = shown[0] - offset;
    const double max = shown[1] - offset;
    if (!(std::abs(min) <= most && std::abs(max) <= most)) return std::nullopt;
    const ValueRange range{static_cast<float>(min), static_cast<float>(max)};
    return range.min < range.max ? std::optional(range) : std::nullopt;
}

void require_range(const std::optional<std::array<double, 2>>& wanted, double offset) {
    if (wanted && !without_offset(*wanted, offset))
        throw UsageError(fmt::format("--range: expected MIN,MAX, ascending as floats, got '{},{}'",
                                     (*wanted)[0], (*wanted)[1]));
}

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
    if (is_measured(display.coloring)) require_range(display.wanted_range, 0);
    if (display.coloring != Coloring::field) return;
    if (const FamilyField* const field = find_field(fields, display.field)) {
        if (field->label.kind == FieldKind::scalar) require_range(display.wanted_range, field->offset);
        return;
    }
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
    if (is_measured(display.coloring) && display.wanted_range) {
        if (const auto range = without_offset(*std::exchange(display.wanted_range, std::nullopt), 0))
            display.measured_range = {display.coloring, *range};
        display.range_locked = false;  // that of a field
    }
    if (fields.empty()) {
        if (display.coloring == Coloring::field) display.coloring = Coloring::plain;
        display.field.clear();
        return;
    }
    if (find_field(fields, display.field) == nullptr) display.field = fields.front().label.name;
    const FamilyField& field = *find_field(fields, display.field);
    if (field.label.kind != FieldKind::scalar) return;
    if (const auto wanted = std::exchange(display.wanted_range, std::nullopt))
        display.scale.range =
            without_offset(*wanted, field.offset).value_or(ValueRange{field.min, field.max});
    else if (display.range_locked)
        move_offset(display.scale, field.offset);
    else
        display.scale.range = {field.min, field.max};
    display.scale.offset = field.offset;
}

}  // namespace interleaf
