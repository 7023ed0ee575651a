// The depths of a drawn picture, which tell what the surface hides.
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace interleaf {

struct PictureDepths {
    int width;                      ///< pixels
    int height;                     ///< pixels
    std::span<const float> depths;  ///< of all pixels, top row first
};

/// The place of \p position in the picture in pixels, y down, and its depth; w is the distance along the view,
/// or 0 behind the camera.
/// \param to_clip  projection times view
glm::vec4 placed_in_picture(const glm::mat4& to_clip, const glm::vec3& position,
                            const PictureDepths& picture);

/// Whether a point at \p place is in the picture, with nothing in front of it.
bool is_visible(const glm::vec4& place, const PictureDepths& picture);

}  // namespace interleaf
