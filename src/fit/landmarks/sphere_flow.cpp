#include "fit/landmarks/sphere_flow.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Cholesky>
#include <glm/geometric.hpp>

#include "fit/sphere_map/spherical_star.h"

namespace interleaf {
namespace {

constexpr int substeps = 4;

/// What is added to the kernel's matrix, so that landmarks that are very near each other do not need very long
/// vectors.
constexpr double ridge = 1e-6;

/// Wendland's kernel of the squared distance of two points.
double kernel(const glm::dvec3& a, const glm::dvec3& b, double radius) {
    const glm::dvec3 offset = a - b;
    const double squared = glm::dot(offset, offset);
    if (squared >= radius * radius) return 0;
    const double r = std::sqrt(squared) / radius;
    const double rest = (1 - r) * (1 - r);
    return rest * rest * (4 * r + 1);
}

/// The part of \p vector in the tangent plane at the unit vector \p point.
glm::dvec3 tangential(const glm::dvec3& vector, const glm::dvec3& point) {
    return vector - glm::dot(vector, point) * point;
}

/// Vectors in the tangent planes at \p centers whose field has the velocities \p wanted there.
std::vector<glm::dvec3> momenta(std::span<const glm::dvec3> centers, std::span<const glm::dvec3> wanted,
                                double radius) {
    const auto count = static_cast<Eigen::Index>(centers.size());
    std::vector<TangentFrame> frames;
    frames.reserve(centers.size());
    for (const glm::dvec3& center : centers) frames.emplace_back(center);
    Eigen::MatrixXd matrix(2 * count, 2 * count);
    Eigen::VectorXd right(2 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const TangentFrame& at = frames[std::size_t(i)];
        right(2 * i) = glm::dot(wanted[std::size_t(i)], at.s_axis);
        right(2 * i + 1) = glm::dot(wanted[std::size_t(i)], at.t_axis);
        for (Eigen::Index j = 0; j < count; ++j) {
            const TangentFrame& from = frames[std::size_t(j)];
            const double weight = kernel(at.center, from.center, radius);
            matrix(2 * i, 2 * j) = weight * glm::dot(at.s_axis, from.s_axis);
            matrix(2 * i, 2 * j + 1) = weight * glm::dot(at.s_axis, from.t_axis);
            matrix(2 * i + 1, 2 * j) = weight * glm::dot(at.t_axis, from.s_axis);
            matrix(2 * i + 1, 2 * j + 1) = weight * glm::dot(at.t_axis, from.t_axis);
        }
        matrix(2 * i, 2 * i) += ridge;
        matrix(2 * i + 1, 2 * i + 1) += ridge;
    }
    const Eigen::VectorXd solved = matrix.ldlt().solve(right);
    std::vector<glm::dvec3> vectors;
    vectors.reserve(centers.size());
    for (Eigen::Index i = 0; i < count; ++i)
        vectors.push_back(solved(2 * i) * frames[std::size_t(i)].s_axis +
                          solved(2 * i + 1) * frames[std::size_t(i)].t_axis);
    return vectors;
}

}  // namespace

void flow(std::span<glm::dvec3> points, std::span<const Index> landmarks, std::span<const glm::dvec3> targets,
          double radius) {
    std::vector<glm::dvec3> centers(landmarks.size());
    std::vector<glm::dvec3> wanted(landmarks.size());
    for (int left = substeps; left > 0; --left) {
        for (std::size_t k = 0; k < landmarks.size(); ++k) {
            centers[k] = points[landmarks[k]];
            wanted[k] = tangential(targets[k] - centers[k], centers[k]) / double(left);
        }
        const std::vector<glm::dvec3> vectors = momenta(centers, wanted, radius);
        for (glm::dvec3& point : points) {
            glm::dvec3 velocity(0);
            for (std::size_t k = 0; k < centers.size(); ++k)
                velocity += kernel(point, centers[k], radius) * vectors[k];
            point = glm::normalize(point + tangential(velocity, point));
        }
    }
    for (std::size_t k = 0; k < landmarks.size(); ++k) points[landmarks[k]] = targets[k];
}

}  // namespace interleaf
