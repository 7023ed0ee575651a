#include "app/pictures/measured_coloring.h"

#include <utility>

namespace interleaf {

void MeasuredColoring::take(const Subject& subject, const UnionMesh& mesh,
                            std::span<const glm::vec3> positions, Renderer& renderer) {
    values_ = surface_values(subject.coloring, mesh, positions);
    renderer.set_values(values_);
    std::pair scale_of{subject.coloring, subject.keys};
    if (scale_of_ != scale_of) scale_ = measured_scale(subject.coloring, mesh);
    scale_of_ = std::move(scale_of);
    subject_ = subject;
}

ColorScale MeasuredColoring::scale() const {
    ColorScale scale = scale_;
    if (kept_range_) scale.range = *kept_range_;
    return scale;
}

std::optional<float> MeasuredColoring::value_at(const Hit& hit, const UnionMesh& mesh) const {
    const bool per_leaf = values_.place == ValuePlace::leaf;
    if (!subject_ || values_.values.size() != (per_leaf ? mesh.leaf_count() : mesh.vertex_count()))
        return std::nullopt;
    if (per_leaf) return values_.values[hit.triangle];
    float value = 0;
    for (int corner = 0; corner < 3; ++corner)
        value += hit.barycentric[corner] *
                 values_.values[mesh.triangles[hit.triangle][static_cast<std::size_t>(corner)]];
    return value;
}

}  // namespace interleaf
