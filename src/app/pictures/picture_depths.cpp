#include "app/pictures/picture_depths.h"

#include <cstddef>

namespace interleaf {
namespace {

/// A point counts as visible if it is at most this much behind what is drawn at its pixel.
constexpr float depth_bias = 2e-4F;

}  // namespace

glm::vec4 placed_in_picture(const glm::mat4& to_clip, const glm::vec3& position,
                            const PictureDepths& picture) {
    const glm::vec4 clip = to_clip * glm::vec4(position, 1);
    if (!(clip.w > 0)) return glm::vec4(0);
    return {(clip.x / clip.w + 1) / 2 * static_cast<float>(picture.width),
            (1 - clip.y / clip.w) / 2 * static_cast<float>(picture.height), (clip.z / clip.w + 1) / 2,
            clip.w};
}

bool is_visible(const glm::vec4& place, const PictureDepths& picture) {
    if (!(place.w > 0) || place.x < 0 || place.y < 0) return false;
    const auto x = static_cast<std::size_t>(place.x);
    const auto y = static_cast<std::size_t>(place.y);
    const auto width = static_cast<std::size_t>(picture.width);
    if (x >= width || y >= static_cast<std::size_t>(picture.height)) return false;
    return place.z <= picture.depths[y * width + x] + depth_bias;
}

}  // namespace interleaf
