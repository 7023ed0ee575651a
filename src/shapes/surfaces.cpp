#include "shapes/surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace interleaf {

glm::dvec3 sphere_surface(const glm::dvec3& u) {
    return u;
}

glm::dvec3 cushion_surface(const glm::dvec3& u, std::span<const double> constants) {
    // With q the squared length of the point on the ray, the equation is a q^2 - b q + c = 0. The smaller
    // root is the cushion's; the larger one belongs to the branches outside |X / length|, |Y| <= 1.
    const double c = constants[0] * constants[0];
    const double along = u.x / constants[1];
    const double x = along * along;
    const double y = u.y * u.y;
    const double a = c * x * y;
    const double b = c * (x + y) + u.z * u.z;
    const double discriminant = std::max(b * b - 4 * a * c, 0.0);
    return std::sqrt(2 * c / (b + std::sqrt(discriminant))) * u;
}

glm::dvec3 star_surface(const glm::dvec3& u, std::span<const double> constants) {
    const double core = constants[0];
    const double arm = constants[1];
    const double sharpness = constants[2];
    // The arms come in opposite pairs, so six axes give all twelve.
    static const double phi = (1 + std::sqrt(5.0)) / 2;
    static const std::array<glm::dvec3, 6> axes = {
        glm::normalize(glm::dvec3(0, 1, phi)), glm::normalize(glm::dvec3(0, 1, -phi)),
        glm::normalize(glm::dvec3(1, phi, 0)), glm::normalize(glm::dvec3(1, -phi, 0)),
        glm::normalize(glm::dvec3(phi, 0, 1)), glm::normalize(glm::dvec3(-phi, 0, 1))};
    double arms = 0;
    for (const glm::dvec3& axis : axes) {
        // The contribution of the opposite arm is below exp(-sharpness) here.
        arms += std::exp(sharpness * (std::abs(glm::dot(u, axis)) - 1));
    }
    return (core + arm * arms) * u;
}

glm::dvec3 bone_surface(const glm::dvec3& u, std::span<const double> constants) {
    const double length = constants[0];
    const double shaft = constants[1];
    const double thicker = constants[2];
    const auto step = [](double t) { return 1 / (1 + std::exp(-14 * (t - 0.62))); };
    const double t = std::abs(u.x);
    // 0 in the middle of the bone, 1 at its ends.
    const double knob = (step(t) - step(0)) / (1 - step(0));
    const double y = u.y * u.y;
    const double w = std::hypot(u.y, u.z);
    const double bulge = w > 0 ? 0.256 * y / w : 0;
    const double x = length * t + knob * (bulge - 0.17 * std::exp(-14 * y));
    // sqrt(1 - t^6) is w times this root.
    const double radius = std::sqrt(1 + t * t + t * t * t * t) * (shaft + thicker * knob);
    return {std::copysign(x, u.x), radius * (1 + 0.75 * knob) * u.y, radius * u.z};
}

}  // namespace interleaf
