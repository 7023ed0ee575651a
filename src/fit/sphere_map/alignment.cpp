#include "fit/sphere_map/alignment.h"

#include <vector>

#include <Eigen/Eigenvalues>
#include <glm/geometric.hpp>

namespace interleaf {
namespace {

/// Directions of the vertices from the surface's center of area. The length of each direction is the
/// vertex's fraction of the area.
std::vector<glm::dvec3> weighted_directions(const SurfaceMesh& mesh) {
    std::vector<double> areas(mesh.positions.size(), 0.0);
    double whole = 0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const glm::dvec3& a = mesh.positions[i];
        const double area = glm::length(glm::cross(mesh.positions[j] - a, mesh.positions[k] - a));
        whole += area;
        for (const Index vertex : {i, j, k}) areas[vertex] += area / 3;
    }
    if (!(whole > 0)) return std::vector<glm::dvec3>(mesh.positions.size(), glm::dvec3(0));
    glm::dvec3 center(0);
    for (std::size_t v = 0; v < areas.size(); ++v) center += areas[v] / whole * mesh.positions[v];

    std::vector<glm::dvec3> directions(mesh.positions.size());
    for (std::size_t v = 0; v < areas.size(); ++v) {
        const glm::dvec3 from_center = mesh.positions[v] - center;
        const double length = glm::length(from_center);
        directions[v] = length > 0 ? areas[v] / whole / length * from_center : glm::dvec3(0);
    }
    return directions;
}

}  // namespace

glm::dmat3 rotation_to_surface(const SurfaceMesh& mesh, std::span<const glm::dvec3> points) {
    const std::vector<glm::dvec3> directions = weighted_directions(mesh);
    Eigen::Matrix3d s = Eigen::Matrix3d::Zero();  // s(i, j) is the sum of u_i d_j
    for (std::size_t v = 0; v < points.size(); ++v)
        s += Eigen::Vector3d(points[v].x, points[v].y, points[v].z) *
             Eigen::RowVector3d(directions[v].x, directions[v].y, directions[v].z);

    // The best rotation, as a quaternion (w, x, y, z), is the eigenvector of the largest eigenvalue.
    Eigen::Matrix4d n;
    n << s(0, 0) + s(1, 1) + s(2, 2), s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0),
        s(1, 2) - s(2, 1), s(0, 0) - s(1, 1) - s(2, 2), s(0, 1) + s(1, 0), s(2, 0) + s(0, 2),
        s(2, 0) - s(0, 2), s(0, 1) + s(1, 0), s(1, 1) - s(0, 0) - s(2, 2), s(1, 2) + s(2, 1),
        s(0, 1) - s(1, 0), s(2, 0) + s(0, 2), s(1, 2) + s(2, 1), s(2, 2) - s(0, 0) - s(1, 1);
    const Eigen::Vector4d best = Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(n).eigenvectors().col(3);
    const Eigen::Matrix3d r = Eigen::Quaterniond(best(0), best(1), best(2), best(3)).normalized().matrix();
    glm::dmat3 rotation;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) rotation[column][row] = r(row, column);
    return rotation;
}

double mean_cosine(const SurfaceMesh& mesh, std::span<const glm::dvec3> points) {
    const std::vector<glm::dvec3> directions = weighted_directions(mesh);
    double mean = 0;
    for (std::size_t v = 0; v < points.size(); ++v) mean += glm::dot(points[v], directions[v]);
    return mean;
}

void rotate(std::span<glm::dvec3> points, const glm::dmat3& rotation) {
    for (glm::dvec3& point : points) point = glm::normalize(rotation * point);
}

}  // namespace interleaf
