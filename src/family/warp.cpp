#include "family/warp.h"

#include <algorithm>
#include <cstddef>

namespace interleaf {

std::optional<unsigned> flat_axis(const Box& box) {
    constexpr float max_thickness = 1e-6F;  // relative to the size
    const glm::vec3 size = box.max - box.min;
    const float largest = std::max({size.x, size.y, size.z});
    for (const unsigned axis : {2U, 1U, 0U})
        if (size[static_cast<int>(axis)] <= max_thickness * largest) return axis;
    return std::nullopt;
}

Hierarchy warped(const Hierarchy& key, const Warp& warp) {
    Hierarchy moved = key;
    const Field* const field = find_field(key.fields, FieldName{warp.field, FieldKind::scalar});
    if (field == nullptr) return moved;
    const auto axis = static_cast<int>(warp.axis);
    for (std::size_t v = 0; v < moved.positions.size(); ++v)
        moved.positions[v][axis] += warp.factor * (field->values[v] - warp.zero);
    return moved;
}

}  // namespace interleaf
