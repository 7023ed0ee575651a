// The camera: it looks at a target point from a distance, in perspective with a vertical field of view of 35
// degrees, or orthographically. It uses arithmetic only, no GL.
//
// Its direction is an azimuth about the vertical axis, an elevation and a roll. A turntable turns by azimuth and
// elevation, a trackball freely. The vertical axis is Y, or another one by set_up().
//
// It knows the extent of the scene. Nothing of the scene is clipped, and shifts and zooms end where the scene would
// be lost: outside the picture, too small to see, or behind the eye.
#pragma once

#include <cstdint>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "hierarchy/measure.h"
#include "hierarchy/up_axis.h"

namespace interleaf {

inline constexpr float vertical_field_degrees = 35.0F;

enum class Projection : std::uint8_t { perspective, orthographic };

/// How a drag turns the camera.
enum class OrbitStyle : std::uint8_t {
    turntable,  ///< about the vertical axis, and up and down to the poles
    trackball,  ///< about the axes of the picture, without end
};

/// A direction of view; degrees.
struct Direction {
    float azimuth = 0;    ///< about the vertical axis; 0 from the front, which is +Z while Y is up
    float elevation = 0;  ///< above the horizontal plane, -90 to 90
    float roll = 0;       ///< of the picture about its center, counterclockwise
    bool operator==(const Direction&) const = default;
};

class Camera {
  public:
    /// Moves the camera so that the whole of \p extent is in view, with a margin, from the present direction, and
    /// makes it the scene.
    /// \param aspect  width / height of the picture
    void view_all(const Extent& extent, float aspect);

    /// As view_all(), for a part of the scene, which stays.
    void frame(const Extent& extent, float aspect);

    /// Makes \p extent the scene. The picture stays, except that other parts may be clipped.
    void keep_unclipped(const Extent& extent);

    /// Looks from \p azimuth and \p elevation, upright.
    void look_from(float azimuth, float elevation);
    void look_from(const Direction& direction);
    const Direction& direction() const { return direction_; }

    /// Looks along \p axis from the end that it points to, upright.
    void look_from_end(glm::vec3 axis);

    /// Makes \p up the vertical axis. The direction stays, as seen from the new front.
    void set_up(UpAxis up) { up_ = up; }
    UpAxis up() const { return up_; }

    /// Looks at \p target from \p distance, which is above 0.
    void look_at(glm::vec3 target, float distance);
    glm::vec3 target() const { return target_; }
    /// For an orthographic camera, the distance at which a perspective one shows the target as large.
    float distance() const { return distance_; }

    /// The target stays as large as it is.
    void set_projection(Projection projection) { projection_ = projection; }
    Projection projection() const { return projection_; }

    /// Shows the picture as much smaller in the left \p part of its width, 0 to 1, in the middle of its height. What
    /// lay outside the picture appears around it.
    void show_in_left(float part) { left_part_ = part; }

    /// Turns about the vertical axis through the target, by \p degrees.
    void turn(float degrees);

    /// Turns the picture about its center, counterclockwise, by \p degrees.
    void roll(float degrees);

    /// Turns about the target.
    /// \param delta  movement of the pointer in units of the picture's height, x right, y down
    void orbit(glm::vec2 delta, OrbitStyle style = OrbitStyle::turntable);

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

    /// Height of the picture in space, where the clip coordinate w has this value.
    float height_at(float w) const;

    /// Right, up and backward, as columns.
    glm::mat3 axes() const;

    glm::mat4 view() const;
    glm::mat4 projection(float aspect) const;

    /// Position of the camera. An orthographic camera stands in front of the scene.
    glm::vec3 eye() const;

    bool operator==(const Camera&) const = default;

  private:
    glm::mat3 upright_axes() const;
    glm::mat4 whole_projection(float aspect) const;
    void scale_about(glm::vec3 point, float factor, float nearest);
    void keep_in_reach();

    glm::vec3 target_{0};
    Direction direction_;
    float distance_ = 4;
    Projection projection_ = Projection::perspective;
    UpAxis up_ = UpAxis::y;
    float left_part_ = 1;
    glm::vec3 scene_center_{0};
    float scene_radius_ = 1;
};

/// The end of \p axis, 0 to 2, from which a plane across it is seen: the end that points to the viewer, or the
/// positive end of an axis that points up or to the side.
glm::vec3 front_of_plane(unsigned axis, UpAxis up);

}  // namespace interleaf
