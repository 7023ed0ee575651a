#include "sequence/deformation_flow.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace interleaf {
namespace {

/// The longest Runge-Kutta step, in seconds. No point moves by more than twice this length in it.
constexpr double max_part = 0.0125;

glm::dvec3 runge_kutta_step(const glm::dvec3& at, double time, double length, double period) {
    const glm::dvec3 k1 = deformation_velocity(at, time, period);
    const glm::dvec3 k2 = deformation_velocity(at + length / 2 * k1, time + length / 2, period);
    const glm::dvec3 k3 = deformation_velocity(at + length / 2 * k2, time + length / 2, period);
    const glm::dvec3 k4 = deformation_velocity(at + length * k3, time + length, period);
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
    for (unsigned part = first_step * parts_of_step_; part < end_step * parts_of_step_; ++part)
        position = runge_kutta_step(position, part * length, length, period_);
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
