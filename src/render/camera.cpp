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

/// Half the height of the picture at distance 1.
float half_height() {
    return std::tan(glm::radians(vertical_field_degrees / 2));
}

}  // namespace

/// Right, up and backward, as columns.
glm::mat3 Camera::axes() const {
    const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(azimuth_), glm::vec3(0, 1, 0));
    return glm::mat3(glm::rotate(turn, glm::radians(-elevation_), glm::vec3(1, 0, 0)));
}

void Camera::view_all(const Extent& extent, float aspect) {
    const Box& box = extent.box;
    scene_center_ = box.center();
    scene_radius_ = extent.radius > 0 ? extent.radius : 1;
    target_ = scene_center_;
    const float tangent = half_height() / margin;
    const float sphere_distance = scene_radius_ / std::sin(std::atan(tangent * std::min(aspect, 1.0F)));

    float box_distance = scene_radius_ / 100;
    const glm::vec3 half = (box.max - box.min) / 2.0F;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 signs((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                              (corner & 4) != 0 ? 1 : -1);
        const glm::vec3 seen = glm::transpose(axes()) * (signs * half);
        const float reach = std::max(std::abs(seen.x) / aspect, std::abs(seen.y));
        box_distance = std::max(box_distance, seen.z + reach / tangent);
    }
    distance_ = std::min(sphere_distance, box_distance);
}

void Camera::keep_unclipped(const Extent& extent) {
    scene_center_ = extent.box.center();
    scene_radius_ = extent.radius > 0 ? extent.radius : 1;
}

void Camera::look_from(float azimuth, float elevation) {
    azimuth_ = std::remainder(azimuth, 360.0F);
    elevation_ = std::clamp(elevation, -90.0F, 90.0F);
}

void Camera::turn(float degrees) {
    look_from(azimuth_ + degrees, elevation_);
}

void Camera::orbit(glm::vec2 delta) {
    constexpr float degrees_per_height = 180;
    look_from(azimuth_ - delta.x * degrees_per_height, elevation_ + delta.y * degrees_per_height);
}

void Camera::pan(glm::vec2 delta) {
    const float height = 2 * half_height() * distance_;
    target_ += axes() * (height * glm::vec3(-delta.x, delta.y, 0));
}

void Camera::center(glm::vec3 point) {
    const glm::vec3 offset = glm::transpose(axes()) * (point - target_);
    target_ += axes() * glm::vec3(offset.x, offset.y, 0);
}

void Camera::zoom(float factor, glm::vec2 pointer, float aspect) {
    const glm::vec3 offset(pointer.x * aspect, pointer.y, 0);
    approach(factor, target_ + axes() * (half_height() * distance_ * offset));
}

void Camera::approach(float factor, glm::vec3 point) {
    // A similarity about the point keeps every direction to it. The limits keep the floats precise enough.
    const float nearest = scene_radius_ * 1e-4F;
    const float farthest = scene_radius_ * 1e3F;
    const float scale = std::clamp(distance_ / factor, nearest, farthest) / distance_;
    target_ = point + (target_ - point) * scale;
    distance_ *= scale;
}

glm::vec3 Camera::point_at(glm::vec2 pointer, float depth, float aspect) const {
    const glm::vec4 point = glm::inverse(projection(aspect) * view()) * glm::vec4(pointer, 2 * depth - 1, 1);
    return glm::vec3(point) / point.w;
}

glm::vec3 Camera::eye() const {
    return target_ + axes()[2] * distance_;
}

glm::mat4 Camera::view() const {
    const glm::mat3 to_camera = glm::transpose(axes());
    glm::mat4 view(to_camera);
    view[3] = glm::vec4(-(to_camera * eye()), 1);
    return view;
}

glm::mat4 Camera::projection(float aspect) const {
    // Twice the radius, because weights outside 0 to 1 leave the box in view. Inside the scene, the near
    // plane follows the distance, so that an approach clips nothing that is in clear view.
    const float depth = glm::dot(eye() - scene_center_, axes()[2]);
    const float near = std::max(depth - 2 * scene_radius_, distance_ / 100);
    const float far = std::max(depth + 2 * scene_radius_, 2 * near);
    return glm::perspective(glm::radians(vertical_field_degrees), aspect, near, far);
}

}  // namespace interleaf
