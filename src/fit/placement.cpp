#include "fit/placement.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace interleaf {

void turn_up(std::vector<glm::dvec3>& positions, UpAxis up) {
    if (up == UpAxis::y) return;
    for (glm::dvec3& p : positions)
        p = up == UpAxis::x ? glm::dvec3(-p.y, p.x, p.z) : glm::dvec3(p.x, p.z, -p.y);
}

void turn_back(std::vector<glm::dvec3>& positions, UpAxis up) {
    if (up == UpAxis::y) return;
    for (glm::dvec3& p : positions)
        p = up == UpAxis::x ? glm::dvec3(p.y, -p.x, p.z) : glm::dvec3(p.x, -p.z, p.y);
}

SurfaceExtent extent_of(const SurfaceMesh& mesh) {
    const glm::dvec3 origin = mesh.positions[mesh.triangles.front()[0]];
    SurfaceExtent extent{.size = 0, .center = origin, .least = origin, .most = origin};
    double area = 0;
    glm::dvec3 moment(0);
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 corners[] = {mesh.positions[a] - origin, mesh.positions[b] - origin,
                                      mesh.positions[c] - origin};
        const double part = glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
        area += part;
        moment += part / 3 * (corners[0] + corners[1] + corners[2]);
        for (const glm::dvec3& corner : corners) {
            extent.least = glm::min(extent.least, corner + origin);
            extent.most = glm::max(extent.most, corner + origin);
        }
    }
    extent.size = std::sqrt(area);
    if (area > 0) extent.center += moment / area;
    return extent;
}

void place(CleanMesh& mesh, const SurfaceExtent& first, const PlacingOptions& options) {
    if (!options.same_size && !options.same_center) return;
    const SurfaceExtent own = extent_of(mesh.mesh);
    const double scale = options.same_size && own.size > 0 ? first.size / own.size : 1;
    const glm::dvec3 center = options.same_center ? first.center : own.center;
    for (SurfaceMesh* part : {&mesh.mesh, &mesh.dropped})
        for (glm::dvec3& p : part->positions) p = scale * (p - own.center) + center;
}

std::string fault_of_placing(const SurfaceExtent& first, const SurfaceExtent& other) {
    constexpr double max_ratio = 3;
    const double ratio = std::max(first.size, other.size) / std::min(first.size, other.size);
    if (ratio > max_ratio)
        return fmt::format("is {:.3g} times as {} as the first (square root of the area)", ratio,
                           other.size > first.size ? "large" : "small");
    const bool is_apart = glm::any(glm::greaterThan(other.least, first.most)) ||
                          glm::any(glm::lessThan(other.most, first.least));
    return is_apart ? "lies apart from the first: their boxes do not touch" : "";
}

}  // namespace interleaf
