#include "family/vector_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace interleaf {
namespace {

/// The scalar called \p name; null if there is none.
const FamilyField* scalar_named(std::span<const FamilyField> fields, std::string_view name) {
    const FamilyField* const field = find_field(fields, name);
    return field != nullptr && field->label.kind == FieldKind::scalar ? field : nullptr;
}

}  // namespace

std::optional<VectorField> vector_of(std::span<const FamilyField> fields, std::string_view name) {
    constexpr std::array<std::string_view, 3> axes = {" x", " y", " z"};
    const bool is_part =
        std::ranges::any_of(axes, [&](std::string_view axis) { return name.ends_with(axis); });
    if (!is_part || name.size() <= 2) return std::nullopt;
    const std::string stem(name.substr(0, name.size() - 2));
    std::array<std::string, 3> parts;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) parts[axis] = stem + std::string(axes[axis]);
    if (scalar_named(fields, parts[2]) == nullptr) parts[2].clear();
    std::optional<VectorField> vector = vector_of_parts(fields, parts);
    if (vector) vector->name = stem;
    return vector;
}

std::optional<VectorField> vector_of_parts(std::span<const FamilyField> fields,
                                           const std::array<std::string, 3>& parts) {
    VectorField vector{.name = parts[0], .parts = parts};
    double squares = 0;
    for (std::size_t axis = 0; axis < parts.size(); ++axis) {
        if (axis == 2 && parts[axis].empty()) break;
        const FamilyField* const field = scalar_named(fields, parts[axis]);
        if (field == nullptr) return std::nullopt;
        const double most = std::max(std::abs(double{field->min} + field->offset),
                                     std::abs(double{field->max} + field->offset));
        squares += most * most;
    }
    vector.largest = static_cast<float>(std::sqrt(squares));
    return vector;
}

}  // namespace interleaf
