// Turning, shifting and approaching, and the clipping planes.
#include "render/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace interleaf {
namespace {

constexpr float margin = 1.08F;

/// By how much a drag over the height of the picture turns the camera.
constexpr float degrees_per_height = 180;

// The limits of the distance, in radii of the scene. Nearer, the steps of floats would show.
constexpr float nearest_to_surface = 5e-4F;
constexpr float nearest_to_nothing = 0.02F;  // a zoom past the surface would end where nothing is to be seen
constexpr float farthest = 40;

/// Half the height of the picture at distance 1.
float half_height() {
    return std::tan(glm::radians(vertical_field_degrees / 2));
}

float radius_of(const Extent& extent) {
    return extent.radius > 0 ? extent.radius : 1;
}

/// The direction from where \p back points.
Direction direction_towards(glm::vec3 back) {
    back += 0.0F;  // so that no component is -0, from which atan2 would turn by 180 degrees at a pole
    return {
        .azimuth = glm::degrees(std::atan2(back.x, back.z)),
        .elevation = glm::degrees(std::atan2(back.y, std::hypot(back.x, back.z))),
    };
}

/// The direction of a camera with these axes, while Y is up.
Direction direction_of(const glm::mat3& axes) {
    const glm::vec3 back = axes[2];
    Direction direction = direction_towards(back);
    const glm::vec3 right(std::cos(glm::radians(direction.azimuth)), 0,
                          -std::sin(glm::radians(direction.azimuth)));
    direction.roll =
        glm::degrees(std::atan2(-glm::dot(axes[0], glm::cross(back, right)), glm::dot(axes[0], right)));
    return direction;
}

}  // namespace

/// As axes(), without the roll.
glm::mat3 Camera::upright_axes() const {
    const glm::mat4 turn =
        glm::rotate(glm::mat4(axes_with(up_)), glm::radians(direction_.azimuth), glm::vec3(0, 1, 0));
    return glm::mat3(glm::rotate(turn, glm::radians(-direction_.elevation), glm::vec3(1, 0, 0)));
}

glm::mat3 Camera::axes() const {
    if (direction_.roll == 0) return upright_axes();
    return glm::mat3(
        glm::rotate(glm::mat4(upright_axes()), glm::radians(-direction_.roll), glm::vec3(0, 0, 1)));
}

void Camera::view_all(const Extent& extent, float aspect) {
    keep_unclipped(extent);
    frame(extent, aspect);
}

void Camera::frame(const Extent& extent, float aspect) {
    const Box& box = extent.box;
    target_ = box.center();
    const bool is_perspective = projection_ == Projection::perspective;
    const float tangent = half_height() / margin;
    const float narrow = tangent * std::min(aspect, 1.0F);
    const float radius = radius_of(extent);
    const float sphere_distance = radius / (is_perspective ? std::sin(std::atan(narrow)) : narrow);

    float box_distance = radius / 100;
    const glm::vec3 half = (box.max - box.min) / 2.0F;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 signs((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                              (corner & 4) != 0 ? 1 : -1);
        const glm::vec3 seen = glm::transpose(axes()) * (signs * half);
        const float reach = std::max(std::abs(seen.x) / aspect, std::abs(seen.y));
        box_distance = std::max(box_distance, (is_perspective ? seen.z : 0) + reach / tangent);
    }
    distance_ = std::max(std::min(sphere_distance, box_distance), nearest_to_surface * scene_radius_);
}

void Camera::keep_unclipped(const Extent& extent) {
    scene_center_ = extent.box.center();
    scene_radius_ = radius_of(extent);
}

void Camera::look_from(float azimuth, float elevation) {
    look_from({azimuth, elevation, 0});
}

void Camera::look_from(const Direction& direction) {
    direction_ = {std::remainder(direction.azimuth, 360.0F), std::clamp(direction.elevation, -90.0F, 90.0F),
                  std::remainder(direction.roll, 360.0F)};
}

void Camera::look_from_end(glm::vec3 axis) {
    look_from(direction_towards(glm::transpose(axes_with(up_)) * axis));
}

void Camera::look_at(glm::vec3 target, float distance) {
    target_ = target;
    distance_ = distance;
}

void Camera::turn(float degrees) {
    look_from({direction_.azimuth + degrees, direction_.elevation, direction_.roll});
}

void Camera::roll(float degrees) {
    look_from({direction_.azimuth, direction_.elevation, direction_.roll + degrees});
}

void Camera::orbit(glm::vec2 delta, OrbitStyle style) {
    if (delta == glm::vec2(0)) return;
    if (style == OrbitStyle::trackball) {
        const float angle = glm::radians(degrees_per_height * glm::length(delta));
        const glm::mat3 turned(glm::rotate(glm::mat4(axes()), angle, glm::vec3(-delta.y, -delta.x, 0)));
        direction_ = direction_of(glm::transpose(axes_with(up_)) * turned);
        return;
    }
    // The drag as an upright picture would see it.
    const float turned = glm::radians(direction_.roll);
    const float across = delta.x * std::cos(turned) - delta.y * std::sin(turned);
    const float down = delta.x * std::sin(turned) + delta.y * std::cos(turned);
    look_from({direction_.azimuth - across * degrees_per_height,
               direction_.elevation + down * degrees_per_height, direction_.roll});
}

void Camera::pan(glm::vec2 delta) {
    if (delta == glm::vec2(0)) return;
    const float height = 2 * half_height() * distance_;
    target_ += axes() * (height * glm::vec3(-delta.x, delta.y, 0));
    keep_in_reach();
}

void Camera::center(glm::vec3 point) {
    const glm::vec3 offset = glm::transpose(axes()) * (point - target_);
    target_ += axes() * glm::vec3(offset.x, offset.y, 0);
}

void Camera::zoom(float factor, glm::vec2 pointer, float aspect) {
    const glm::vec3 offset(pointer.x * aspect, pointer.y, 0);
    scale_about(target_ + axes() * (half_height() * distance_ * offset), factor, nearest_to_nothing);
}

void Camera::approach(float factor, glm::vec3 point) {
    scale_about(point, factor, nearest_to_surface);
}

/// A similarity about the point keeps every direction to it.
/// \param nearest  distance beyond which the camera comes no nearer, in radii of the scene
void Camera::scale_about(glm::vec3 point, float factor, float nearest) {
    const float low = std::min(nearest * scene_radius_, distance_);
    const float high = std::max(farthest * scene_radius_, distance_);
    const float scale = std::clamp(distance_ / factor, low, high) / distance_;
    target_ = point + (target_ - point) * scale;
    distance_ *= scale;
    keep_in_reach();
}

/// Shifts the target so that the sphere of the scene is neither outside the picture nor behind the eye.
void Camera::keep_in_reach() {
    const float shown = 0.8F * half_height() * distance_;
    const glm::vec3 offset = glm::transpose(axes()) * (target_ - scene_center_);
    const float aside = glm::length(glm::vec2(offset));
    const float scale = std::min(1.0F, (scene_radius_ + shown) / std::max(aside, 1e-30F));
    const glm::vec3 kept(glm::vec2(offset) * scale, std::clamp(offset.z, -scene_radius_, scene_radius_));
    if (kept != offset) target_ = scene_center_ + axes() * kept;
}

glm::vec3 Camera::point_at(glm::vec2 pointer, float depth, float aspect) const {
    const glm::vec4 point = glm::inverse(projection(aspect) * view()) * glm::vec4(pointer, 2 * depth - 1, 1);
    return glm::vec3(point) / point.w;
}

float Camera::height_at(float w) const {
    return 2 * half_height() * (projection_ == Projection::perspective ? w : distance_) / left_part_;
}

glm::vec3 Camera::eye() const {
    const glm::vec3 back = axes()[2];
    if (projection_ == Projection::perspective) return target_ + back * distance_;
    return target_ + back * (glm::dot(scene_center_ - target_, back) + 4 * scene_radius_);
}

glm::mat4 Camera::view() const {
    const glm::mat3 to_camera = glm::transpose(axes());
    glm::mat4 view(to_camera);
    view[3] = glm::vec4(-(to_camera * eye()), 1);
    return view;
}

glm::mat4 Camera::projection(float aspect) const {
    glm::mat4 to_left(1);
    to_left[0][0] = to_left[1][1] = left_part_;
    to_left[3][0] = left_part_ - 1;
    return to_left * whole_projection(aspect);
}

/// The projection that fills the whole picture.
glm::mat4 Camera::whole_projection(float aspect) const {
    // Twice the radius, because weights outside 0 to 1 leave the box in view. Inside the scene, the near
    // plane follows the distance, so that an approach clips nothing that is in clear view.
    const float depth = glm::dot(eye() - scene_center_, axes()[2]);
    if (projection_ == Projection::orthographic) {
        const float half = half_height() * distance_;
        return glm::ortho(-half * aspect, half * aspect, -half, half, depth - 2 * scene_radius_,
                          depth + 2 * scene_radius_);
    }
    const float near = std::max(depth - 2 * scene_radius_, distance_ / 100);
    const float far = std::max(depth + 2 * scene_radius_, 2 * near);
    return glm::perspective(glm::radians(vertical_field_degrees), aspect, near, far);
}

glm::vec3 front_of_plane(unsigned axis, UpAxis up) {
    const auto place = static_cast<glm::length_t>(axis);
    glm::vec3 front(0);
    front[place] = axes_with(up)[2][place] < 0 ? -1.0F : 1.0F;
    return front;
}

}  // namespace interleaf
