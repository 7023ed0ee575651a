#include "family/vector_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace interleaf {

std::optional<VectorField> vector_of(std::span<const FamilyField> fields, std::string_view name) {
    constexpr std::array<std::string_view, 3> axes = {" x", " y", " z"};
    const bool is_part =
        std::ranges::any_of(axes, [&](std::string_view axis) { return name.ends_with(axis); });
    if (!is_part || name.size() <= 2) return std::nullopt;
    VectorField vector{std::string(name.substr(0, name.size() - 2))};
    float squares = 0;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        const std::string part = vector.name + std::string(axes[axis]);
        const FamilyField* const field = find_field(fields, part);
        if (field == nullptr || field->label.kind != FieldKind::scalar) {
            if (axis < 2) return std::nullopt;
            break;
        }
        vector.parts[axis] = part;
        const float most = std::max(std::abs(field->min), std::abs(field->max));
        squares += most * most;
    }
    vector.largest = std::sqrt(squares);
    return vector;
}

}  // namespace interleaf
