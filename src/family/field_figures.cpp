#include "family/field_figures.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace interleaf {

FieldFigures figures_of(const Hierarchy& key, const Field& field, double offset) {
    FieldFigures figures;
    for (const Leaf& leaf : leaves_of(key)) {
        const auto& [a, b, c] = leaf.vertices;
        const glm::dvec3 from(key.positions[a]);
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(key.positions[b]) - from, glm::dvec3(key.positions[c]) - from);
        figures.integral +=
            glm::length(normal) / 6 *
            (double{field.values[a]} + double{field.values[b]} + double{field.values[c]} + 3 * offset);
    }
    const auto [least, most] = std::ranges::minmax(field.values);
    figures.least = double{least} + offset;
    figures.most = double{most} + offset;
    return figures;
}

}  // namespace interleaf
