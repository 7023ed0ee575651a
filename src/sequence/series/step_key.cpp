#include "sequence/series/step_key.h"

#include <cassert>

namespace interleaf {

Hierarchy key_of_step(const StepMesh& step, const RootComplex& roots, std::span<const Index> root_vertices,
                      std::vector<Leaf> leaves, const SeriesFields& fields) {
    // The vertices of the roots come first.
    std::vector<Index> number(step.points.size(), no_index);
    std::vector<Index> order(root_vertices.begin(), root_vertices.end());
    order.reserve(step.points.size());
    for (Index v = 0; v < order.size(); ++v) number[order[v]] = v;
    for (Index v = 0; v < step.points.size(); ++v)
        if (number[v] == no_index) {
            number[v] = static_cast<Index>(order.size());
            order.push_back(v);
        }
    for (Leaf& leaf : leaves)
        for (Index& vertex : leaf.vertices) vertex = number[vertex];

    std::vector<glm::vec3> positions;
    positions.reserve(order.size());
    for (const Index v : order) positions.emplace_back(step.position(v));
    std::vector<Field> scalars;
    for (std::size_t s = 0; s < fields.scalars.size(); ++s) {
        Field& field = scalars.emplace_back(Field{fields.scalars[s].name, FieldKind::scalar, {}});
        field.values.reserve(order.size());
        for (const Index v : order) field.values.push_back(static_cast<float>(step.values[s][v]));
    }
    return hierarchy_from_leaves(roots, leaves, positions, scalars);
}

}  // namespace interleaf
