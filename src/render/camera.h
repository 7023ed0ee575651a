// The camera: it looks at a target point from a distance, Y up, with a vertical field of view of 35 degrees.
// It uses arithmetic only, no GL.
//
// It turns like a turntable: about the vertical axis, and up and down. It never rolls.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "hierarchy/measure.h"

namespace interleaf {

inline constexpr float vertical_field_degrees = 35.0F;

class Camera {
  public:
    /// Moves the camera so that the whole of \p extent is in view, with a margin, from the present direction.
    /// \param aspect  width / height of the picture
    void view_all(const Extent& extent, float aspect);

    /// Moves the clipping planes so that \p extent is not clipped. The picture stays otherwise.
    void keep_unclipped(const Extent& extent);

    /// Looks from \p azimuth (about Y, 0 from +Z) and \p elevation (above the XZ plane, -90 to 90), both in
    /// degrees.
    void look_from(float azimuth, float elevation);

    /// Turns about the vertical axis through the target, by \p degrees.
    void turn(float degrees);

    /// Turns about the target.
    /// \param delta  movement of the pointer in units of the picture's height, x right, y down
    void orbit(glm::vec2 delta);

    /// Shifts the target so that it stays under the pointer.
    /// \param delta  as in orbit()
    void pan(glm::vec2 delta);

    /// Shifts the target so that \p point is at the center of the picture.
    void center(glm::vec3 point);

    /// Zooms by \p factor; above 1 the camera moves nearer. The point under the pointer, at the target's
    /// depth, stays there.
    /// \param pointer  in normalized device coordinates, -1 to 1, y up
    void zoom(float factor, glm::vec2 pointer, float aspect);

    /// Moves nearer to the world point \p point by \p factor. The point keeps its place in the picture, so
    /// repeated calls make the surface around it fill the picture.
    void approach(float factor, glm::vec3 point);

    /// The world point under \p pointer (as in zoom()) at \p depth, 0 to 1 as in the depth buffer.
    glm::vec3 point_at(glm::vec2 pointer, float depth, float aspect) const;

    glm::mat4 view() const;
    glm::mat4 projection(float aspect) const;
    glm::vec3 eye() const;

    bool operator==(const Camera&) const = default;

  private:
    glm::mat3 axes() const;

    glm::vec3 target_{0};
    float azimuth_ = 0;    ///< degrees
    float elevation_ = 0;  ///< degrees
    float distance_ = 4;
    glm::vec3 scene_center_{0};  ///< of the extent in view, for the clipping planes
    float scene_radius_ = 1;
};

}  // namespace interleaf
