#include "hierarchy/detail/view_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace interleaf {

namespace {

constexpr float half_turn = std::numbers::pi_v<float>;

/// Distances below this part of a ball's radius count as this one, so that errors stay finite near the eye.
constexpr float nearest_part = 0.05F;

/// The magnification outside the picture halves with every such angle, radians, down to least_outside.
constexpr float halving_angle = 0.1F;
constexpr float least_outside = 1.0F / 64;

constexpr float least_in_front = 1.0F / 4;
constexpr float least_behind = 1.0F / 16;

/// The angle under which the eye sees the radius of \p ball at \p distance from its center.
float angular_radius(const Ball& ball, float distance) {
    return distance > ball.radius ? std::asin(ball.radius / distance) : half_turn;
}

}  // namespace

float magnification(const ViewPoint& view, const Ball& ball) {
    const glm::vec3 toward = ball.center - view.eye;
    const float distance = glm::length(toward);
    const float nearest = std::max({distance - ball.radius, nearest_part * ball.radius, 1e-30F});
    float factor = 1;
    if (distance > ball.radius) {
        const float cosine = std::clamp(glm::dot(toward, view.forward) / distance, -1.0F, 1.0F);
        const float outside = std::acos(cosine) - angular_radius(ball, distance) - view.half_angle;
        if (outside > 0) factor = std::max(std::exp2(-outside / halving_angle), least_outside);
    }
    return factor / nearest;
}

float prominence(const ViewPoint& view, const Ball& ball, const NormalCone& cone, bool is_closed) {
    const glm::vec3 to_eye = view.eye - ball.center;
    const float distance = glm::length(to_eye);
    if (!(distance > ball.radius)) return 1;
    const float angle = std::acos(std::clamp(glm::dot(cone.axis, to_eye) / distance, -1.0F, 1.0F));
    const float spread = cone.half_angle + angular_radius(ball, distance);
    // The angle from the silhouette, where normals are perpendicular to the view.
    const float away = std::abs(angle - half_turn / 2) - spread;
    if (away <= 0) return 1;
    const float least = is_closed && angle > half_turn / 2 ? least_behind : least_in_front;
    const float cosine = std::cos(std::min(away, half_turn / 2));
    return least + (1 - least) * cosine * cosine * cosine * cosine;
}

}  // namespace interleaf
