// Moebius centering (Baden, Crane and Kazhdan 2018, "Moebius Registration", algorithm 1).
#include <cmath>

#include <Eigen/Cholesky>
#include <glm/geometric.hpp>

#include "fit/mesh/unit_box.h"
#include "fit/sphere_map/spherical_map.h"

namespace interleaf {
namespace {

/// The part of the surface's area that lies around each vertex.
std::vector<double> vertex_weights(const SurfaceMesh& mesh) {
    const std::vector<glm::dvec3> positions = in_unit_box(mesh.positions);
    std::vector<double> weights(positions.size());
    double whole = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const double area = glm::length(glm::cross(positions[b] - positions[a], positions[c] - positions[a]));
        for (const Index vertex : {a, b, c}) weights[vertex] += area;
        whole += 3 * area;
    }
    if (whole > 0)
        for (double& weight : weights) weight /= whole;
    return weights;
}

glm::dvec3 center_of_mass(std::span<const glm::dvec3> points, std::span<const double> weights) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < points.size(); ++i) sum += weights[i] * points[i];
    return sum;
}

/// The inversion that would bring the center of mass to the origin if the effect were linear.
glm::dvec3 newton_inversion(std::span<const glm::dvec3> points, std::span<const double> weights) {
    Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d p(points[i].x, points[i].y, points[i].z);
        slope += 2 * weights[i] * (Eigen::Matrix3d::Identity() - p * p.transpose());
    }
    const glm::dvec3 mass = center_of_mass(points, weights);
    const Eigen::Vector3d c = -slope.ldlt().solve(Eigen::Vector3d(mass.x, mass.y, mass.z));
    return {c.x(), c.y(), c.z()};
}

/// The Moebius map of the sphere that moves its middle to \p c, |c| < 1.
std::vector<glm::dvec3> inverted(std::span<const glm::dvec3> points, const glm::dvec3& c) {
    std::vector<glm::dvec3> moved;
    moved.reserve(points.size());
    for (const glm::dvec3& p : points) {
        const glm::dvec3 sum = p + c;
        moved.push_back(glm::normalize((1 - glm::dot(c, c)) / glm::dot(sum, sum) * sum + c));
    }
    return moved;
}

/// The points after a Newton step that brings the center of mass nearer to the origin; empty if none does.
std::vector<glm::dvec3> centered_once(std::span<const glm::dvec3> points, std::span<const double> weights,
                                      double max_step) {
    constexpr int max_halvings = 20;
    const double mass = glm::length(center_of_mass(points, weights));
    glm::dvec3 c = newton_inversion(points, weights);
    const double length = glm::length(c);
    if (!std::isfinite(length)) return {};
    if (length > max_step) c *= max_step / length;
    for (int i = 0; i < max_halvings; ++i, c *= 0.5) {
        std::vector<glm::dvec3> moved = inverted(points, c);
        if (glm::length(center_of_mass(moved, weights)) < mass) return moved;
    }
    return {};
}

}  // namespace

void center_map(const SurfaceMesh& mesh, std::vector<glm::dvec3>& points) {
    constexpr double centered = 1e-10;
    constexpr double longest = 0.8;  // an inversion near the sphere's radius would tear the map to one side
    constexpr double shortest = 0.01;
    constexpr int max_steps = 100;
    const std::vector<double> weights = vertex_weights(mesh);
    // Great circles do not stay great circles, so a triangle much longer than wide can flip. Then shorter
    // steps follow, as long as they succeed.
    for (double step = longest; step > shortest; step /= 8) {
        std::vector<glm::dvec3> valid = points;
        std::vector<glm::dvec3> moved = points;
        for (int i = 0; i < max_steps && !moved.empty(); ++i) {
            if (glm::length(center_of_mass(moved, weights)) < centered) break;
            std::vector<glm::dvec3> next = centered_once(moved, weights, step);
            if (next.empty()) break;
            moved = std::move(next);
            if (step < longest) {
                if (!fault_of_map(mesh, moved).empty()) break;
                valid = moved;
            }
        }
        if (step < longest) {
            points = std::move(valid);
        } else if (fault_of_map(mesh, moved).empty()) {
            points = std::move(moved);
            return;
        }
    }
}

}  // namespace interleaf
