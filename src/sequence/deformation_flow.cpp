#include "sequence/deformation_flow.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace interleaf {
namespace {

/// The longest Runge-Kutta step, in seconds. No point moves by more than twice this length in it.
constexpr double max_part = 0.0125;

/// A step of \p length seconds from \p time on.
/// \param velocity  of a point at a time
template <typename Velocity>
glm::dvec3 runge_kutta_step(const glm::dvec3& at, double time, double length, const Velocity& velocity) {
    const glm::dvec3 k1 = velocity(at, time);
    const glm::dvec3 k2 = velocity(at + length / 2 * k1, time + length / 2);
    const glm::dvec3 k3 = velocity(at + length / 2 * k2, time + length / 2);
    const glm::dvec3 k4 = velocity(at + length * k3, time + length);
    return at + length / 6 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

}  // namespace

glm::dvec3 deformation_velocity(const glm::dvec3& at, double time, double period) {
    using std::numbers::pi;
    const glm::dvec3 sine(std::sin(pi * at.x), std::sin(pi * at.y), std::sin(pi * at.z));
    const glm::dvec3 cosine(std::cos(pi * at.x), std::cos(pi * at.y), std::cos(pi * at.z));
    const glm::dvec3 squared = sine * sine;
    const glm::dvec3 doubled = 2.0 * sine * cosine;  // the sine of 2 pi x
    return std::cos(pi * time / period) * glm::dvec3(2 * squared.x * doubled.y * doubled.z,
                                                     -doubled.x * squared.y * doubled.z,
                                                     -doubled.x * doubled.y * squared.z);
}

glm::dvec3 flowed_point(const glm::dvec3& direction, double time, double strength, double period) {
    using std::numbers::pi;
    const double distance = strength * period / pi * std::sin(pi * time / period);
    const double parts = std::max(std::ceil(std::abs(distance) / max_part), 1.0);
    glm::dvec3 position = flow_ball_center + flow_ball_radius * direction;
    const auto steady = [](const glm::dvec3& at, double) { return deformation_velocity(at, 0, 1); };
    for (double part = 0; part < parts; ++part)
        position = runge_kutta_step(position, 0, distance / parts, steady);
    return position;
}

FlowingSphere::FlowingSphere(double period, unsigned steps)
    : period_(period),
      step_length_(period / steps),
      parts_of_step_(static_cast<unsigned>(std::ceil(step_length_ / max_part))) {}

std::size_t FlowingSphere::DirectionHash::operator()(const glm::dvec3& direction) const {
    const std::hash<double> hash;
    return hash(direction.x) ^ (hash(direction.y) * 0x9e3779b97f4a7c15) ^
           (hash(direction.z) * 0xc2b2ae3d27d4eb4f);
}

glm::dvec3 FlowingSphere::traced(glm::dvec3 position, unsigned first_step, unsigned end_step) const {
    const double length = step_length_ / parts_of_step_;
    const auto velocity = [this](const glm::dvec3& at, double time) {
        return deformation_velocity(at, time, period_);
    };
    for (unsigned part = first_step * parts_of_step_; part < end_step * parts_of_step_; ++part)
        position = runge_kutta_step(position, part * length, length, velocity);
    return position;
}

glm::dvec3 FlowingSphere::at(const glm::dvec3& direction) {
    const auto [point, is_new] = points_.try_emplace(direction);
    TracedPoint& found = point->second;
    if (is_new) found.position = traced(flow_ball_center + flow_ball_radius * direction, 0, step_);
    found.is_requested = true;
    return found.position;
}

void FlowingSphere::advance() {
    std::erase_if(points_, [](const auto& entry) { return !entry.second.is_requested; });
    for (auto& [direction, point] : points_)
        point = {.position = traced(point.position, step_, step_ + 1), .is_requested = false};
    ++step_;
}

}  // namespace interleaf
