#include <cmath>
#include <numbers>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "fit/sphere_map/orientation.h"
#include "fit/sphere_map/spherical_map.h"

namespace interleaf {
namespace {

/// The solid angle of a spherical triangle (Van Oosterom and Strackee 1983).
double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const double volume = glm::dot(a, glm::cross(b - a, c - a));
    return 2 * std::atan2(volume, 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

bool is_unit(const glm::dvec3& point) {
    return std::abs(glm::dot(point, point) - 1) < 1e-12;
}

}  // namespace

std::string fault_of_map(const SurfaceMesh& mesh, std::span<const glm::dvec3> points) {
    if (points.size() != mesh.positions.size())
        return fmt::format("there are {} points for {} vertices", points.size(), mesh.positions.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!is_unit(points[i])) return fmt::format("point {} is not on the unit sphere", i);

    double whole = 0;
    std::size_t flipped = 0;
    std::size_t first_flipped = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.triangles[i];
        if (orientation(points[a], points[b], points[c]) > 0)
            whole += solid_angle(points[a], points[b], points[c]);
        else if (flipped++ == 0)
            first_flipped = i;
    }
    if (flipped > 0)
        return fmt::format(
            "{} of {} spherical triangles are flipped or have no area, the first is triangle {}", flipped,
            mesh.triangles.size(), first_flipped);
    const double degree = whole / (4 * std::numbers::pi);
    if (std::abs(degree - 1) > 1e-6) return fmt::format("it covers the sphere {:.3g} times", degree);
    return {};
}

}  // namespace interleaf
