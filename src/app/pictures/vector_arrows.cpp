#include "app/pictures/vector_arrows.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>

#include "family/family_fields.h"
#include "hierarchy/morph.h"

namespace interleaf {
namespace {

/// A vertex counts as visible if it is at most this much behind what is drawn at its pixel.
constexpr float depth_bias = 2e-4F;

/// The place of \p position in the picture in pixels, and its depth; w is the distance along the view.
glm::vec4 placed(const glm::mat4& to_clip, const glm::vec3& position, const ArrowPicture& picture) {
    const glm::vec4 clip = to_clip * glm::vec4(position, 1);
    if (!(clip.w > 0)) return glm::vec4(0);
    return {(clip.x / clip.w + 1) / 2 * static_cast<float>(picture.width),
            (1 - clip.y / clip.w) / 2 * static_cast<float>(picture.height), (clip.z / clip.w + 1) / 2,
            clip.w};
}

bool is_visible(const glm::vec4& place, const ArrowPicture& picture) {
    if (!(place.w > 0) || place.x < 0 || place.y < 0) return false;
    const auto x = static_cast<std::size_t>(place.x);
    const auto y = static_cast<std::size_t>(place.y);
    const auto width = static_cast<std::size_t>(picture.width);
    if (x >= width || y >= static_cast<std::size_t>(picture.height)) return false;
    return place.z <= picture.depths[y * width + x] + depth_bias;
}

}  // namespace

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
                                        const ArrowPicture& picture, float cell) const {
    constexpr float longest = 1.5F;  // cells
    const std::vector<float> factors = weight_values(weights);
    const Buffer<glm::vec3> positions = morph(mesh, factors);
    const float aspect = static_cast<float>(picture.width) / static_cast<float>(picture.height);
    const glm::mat4 to_clip = camera.projection(aspect) * camera.view();
    std::set<std::pair<int, int>> taken;
    std::vector<Arrow> arrows;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const glm::vec4 from = placed(to_clip, positions[v], picture);
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
        const glm::vec4 to = placed(to_clip, positions[v] + stretch * vector, picture);
        if (to.w > 0) arrows.push_back({{from.x, from.y}, {to.x, to.y}});
    }
    return arrows;
}

}  // namespace interleaf
