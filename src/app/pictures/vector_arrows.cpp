#include "app/pictures/vector_arrows.h"

#include <algorithm>
#include <set>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "family/family_fields.h"
#include "hierarchy/morph.h"

namespace interleaf {

void VectorArrows::follow(const Family& family, const Weights& weights, const UnionMesh& mesh,
                          std::size_t number, const std::optional<VectorField>& vector) {
    if (vector == vector_ && number == number_) return;
    vector_ = vector;
    number_ = number;
    parts_.clear();
    offsets_.clear();
    if (!vector || !(vector->largest > 0)) return;
    for (const std::string& part : vector->parts) {
        const FieldName label{part, FieldKind::scalar};
        if (part.empty()) break;
        if (key_without(family, weights, label)) return parts_.clear();
        parts_.push_back(united_field(family, weights, mesh, label));
        offsets_.push_back(static_cast<float>(scale_of(family.field_scales, part).offset));
    }
}

std::vector<Arrow> VectorArrows::arrows(const UnionMesh& mesh, const Weights& weights, const Camera& camera,
                                        const PictureDepths& picture, float cell) const {
    constexpr float longest = 1.5F;  // cells
    const std::vector<float> factors = weight_values(weights);
    const Buffer<glm::vec3> positions = morph(mesh, factors);
    const float aspect = static_cast<float>(picture.width) / static_cast<float>(picture.height);
    const glm::mat4 to_clip = camera.projection(aspect) * camera.view();
    std::set<std::pair<int, int>> taken;
    std::vector<Arrow> arrows;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const glm::vec4 from = placed_in_picture(to_clip, positions[v], picture);
        if (!is_visible(from, picture)) continue;
        if (!taken.emplace(static_cast<int>(from.x / cell), static_cast<int>(from.y / cell)).second) continue;
        glm::vec3 vector(0);
        for (std::size_t part = 0; part < parts_.size(); ++part) {
            float& sum = vector[static_cast<int>(part)];
            sum = offsets_[part];
            for (std::size_t key = 0; key < factors.size(); ++key)
                sum += factors[key] * parts_[part].values[key][v];
        }
        const float pixel = camera.height_at(from.w) / static_cast<float>(picture.height);  // in space
        const float stretch = longest * cell * pixel / vector_->largest;
        const glm::vec4 to = placed_in_picture(to_clip, positions[v] + stretch * vector, picture);
        if (to.w > 0) arrows.push_back({{from.x, from.y}, {to.x, to.y}});
    }
    return arrows;
}

}  // namespace interleaf
