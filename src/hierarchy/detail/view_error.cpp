#include "hierarchy/detail/view_error.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace interleaf {

namespace {

/// Distances below this part of a ball's radius count as this one, so that errors stay finite near the eye.
constexpr float nearest_part = 0.05F;

/// The magnification outside the picture halves with every such angle, radians, down to least_outside.
constexpr float halving_angle = 0.1F;
constexpr float least_outside = 1.0F / 64;

constexpr float least_in_front = 1.0F / 4;
constexpr float least_behind = 1.0F / 16;

float cosine_of(float sine) {
    return std::sqrt(std::max(1 - sine * sine, 0.0F));
}

/// The part of the magnification that remains of a ball outside the picture.
/// \param cosine  of the angle between forward and the ball's center, below view.cosine
float part_outside(const ViewPoint& view, float cosine, float sine_of_radius) {
    const float outside =
        std::acos(std::max(cosine, -1.0F)) - std::acos(view.cosine) - std::asin(sine_of_radius);
    return outside > 0 ? std::max(std::exp2(-outside / halving_angle), least_outside) : 1;
}

}  // namespace

SeenBall::SeenBall(const ViewPoint& view, const Ball& ball) {
    const glm::vec3 to_eye = view.eye - ball.center;
    const float distance = glm::length(to_eye);
    is_inside_ = !(distance > ball.radius);
    magnification_ = 1 / std::max({distance - ball.radius, nearest_part * ball.radius, 1e-30F});
    if (is_inside_) return;
    to_eye_ = to_eye / distance;
    sine_ = ball.radius / distance;
    const float cosine = -glm::dot(to_eye_, view.forward);
    if (cosine < view.cosine) magnification_ *= part_outside(view, cosine, sine_);
}

float SeenBall::prominence(const glm::vec3& axis, float sine, bool is_closed) const {
    if (is_inside_ || sine > 1) return 1;
    // The spread of the angles between normals and directions to the eye, about that of the axis.
    const float cone_cosine = cosine_of(sine);
    const float ball_cosine = cosine_of(sine_);
    const float spread_cosine = cone_cosine * ball_cosine - sine * sine_;
    const float spread_sine = sine * ball_cosine + cone_cosine * sine_;
    const float facing = glm::dot(axis, to_eye_);
    const float facing_sine = std::min(std::abs(facing), 1.0F);
    // The axis is asin(|facing|) away from the silhouette.
    if (spread_cosine <= 0 || facing_sine <= spread_sine) return 1;
    const float least = is_closed && facing < 0 ? least_behind : least_in_front;
    const float cosine = cosine_of(facing_sine) * spread_cosine + facing_sine * spread_sine;
    return least + (1 - least) * cosine * cosine * cosine * cosine;
}

}  // namespace interleaf
