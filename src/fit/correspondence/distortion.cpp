#include "fit/correspondence/distortion.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace interleaf {
namespace {

/// Ratios count at least this much, so that a triangle without area has a large energy, not an infinite one.
constexpr double least_ratio = 1e-7;

struct Stretch {
    double squared;     ///< the sum of the squares of the two singular values
    double ratio;       ///< of the areas
    glm::dvec3 normal;  ///< as long as twice the area
    double doubled_area;
};

Stretch stretch_at(const StretchedTriangle& triangle, const glm::dvec3& center) {
    const glm::dvec3 to_a = triangle.a - center;
    const glm::dvec3 to_b = triangle.b - center;
    const glm::dvec3 across = triangle.b - triangle.a;
    const double squared =
        (triangle.cotangent_at_center * glm::dot(across, across) +
         triangle.cotangent_at_b * glm::dot(to_a, to_a) + triangle.cotangent_at_a * glm::dot(to_b, to_b)) /
        (2 * triangle.rest_area);
    const glm::dvec3 normal = glm::cross(to_a, to_b);
    const double doubled_area = glm::length(normal);
    const double ratio = doubled_area / (2 * triangle.rest_area);
    return {std::max(squared, least_ratio), std::max(ratio, least_ratio), normal, doubled_area};
}

double distortion_of(const Stretch& stretch, double rest_area) {
    return rest_area * (1 + stretch.ratio) / 2 * stretch.squared * (1 + 1 / (stretch.ratio * stretch.ratio)) /
           4;
}

}  // namespace

double distortion_of(const StretchedTriangle& triangle, const glm::dvec3& center) {
    return distortion_of(stretch_at(triangle, center), triangle.rest_area);
}

double add_distortion_derivatives(const StretchedTriangle& triangle, const glm::dvec3& center,
                                  const glm::dvec3& s, const glm::dvec3& t, double factor,
                                  TangentDerivatives& sum) {
    const Stretch stretch = stretch_at(triangle, center);
    const double squared = stretch.squared;
    const double ratio = stretch.ratio;
    const double area = triangle.rest_area;
    // The energy is squared * g(ratio), and g(r) = area / 8 (1 + r) (1 + 1/r^2).
    const double inverse = 1 / ratio;
    const double cubed = inverse * inverse * inverse;
    const double g = area / 8 * (1 + ratio) * (1 + inverse * inverse);
    const double g_slope = area / 8 * (1 - inverse * inverse - 2 * cubed);
    const double g_bend = area / 8 * (2 * cubed + 6 * cubed * inverse);

    const glm::dvec3 squared_gradient =
        (triangle.cotangent_at_b * (center - triangle.a) + triangle.cotangent_at_a * (center - triangle.b)) /
        area;
    const glm::dvec3 normal =
        stretch.doubled_area > 0 ? stretch.normal / stretch.doubled_area : stretch.normal;
    const glm::dvec3 ratio_gradient = glm::cross(normal, triangle.b - triangle.a) / (2 * area);
    const glm::dvec2 rise_of_squared(glm::dot(squared_gradient, s), glm::dot(squared_gradient, t));
    const glm::dvec2 rise_of_ratio(glm::dot(ratio_gradient, s), glm::dot(ratio_gradient, t));
    sum.gradient += factor * (g * rise_of_squared + squared * g_slope * rise_of_ratio);

    // Second derivatives in (squared, ratio) are the matrix (0, g'; g', squared g''). One eigenvalue is
    // negative and does not count.
    const double bend = squared * g_bend;
    const double positive = bend / 2 + std::sqrt(bend * bend / 4 + g_slope * g_slope);
    glm::dvec2 axis(g_slope, positive);
    const double axis_length = glm::length(axis);
    axis = axis_length > 0 ? axis / axis_length : glm::dvec2(0, 1);
    const glm::dvec2 along = axis.x * rise_of_squared + axis.y * rise_of_ratio;
    const double in_all_directions =
        g * std::max(triangle.cotangent_at_a + triangle.cotangent_at_b, 0.0) / area;
    sum.second += factor * (positive * glm::outerProduct(along, along) + glm::dmat2(in_all_directions));
    return distortion_of(stretch, area);
}

}  // namespace interleaf
