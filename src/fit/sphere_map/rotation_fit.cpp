#include "fit/sphere_map/rotation_fit.h"

#include <cstddef>

#include <Eigen/Eigenvalues>

namespace interleaf {

RotationFit fit_rotation(std::span<const glm::dvec3> from, std::span<const glm::dvec3> to) {
    Eigen::Matrix3d s = Eigen::Matrix3d::Zero();  // s(i, j) is the sum of from_i to_j
    for (std::size_t v = 0; v < from.size(); ++v)
        s += Eigen::Vector3d(from[v].x, from[v].y, from[v].z) * Eigen::RowVector3d(to[v].x, to[v].y, to[v].z);

    // The best rotation, as a quaternion (w, x, y, z), is the eigenvector of the largest eigenvalue. The least
    // eigenvalue belongs to the rotation that agrees least. A reflection makes it the best one.
    Eigen::Matrix4d n;
    n << s(0, 0) + s(1, 1) + s(2, 2), s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0),
        s(1, 2) - s(2, 1), s(0, 0) - s(1, 1) - s(2, 2), s(0, 1) + s(1, 0), s(2, 0) + s(0, 2),
        s(2, 0) - s(0, 2), s(0, 1) + s(1, 0), s(1, 1) - s(0, 0) - s(2, 2), s(1, 2) + s(2, 1),
        s(0, 1) - s(1, 0), s(2, 0) + s(0, 2), s(1, 2) + s(2, 1), s(2, 2) - s(0, 0) - s(1, 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(n);
    const Eigen::Vector4d best = solver.eigenvectors().col(3);
    const Eigen::Matrix3d r = Eigen::Quaterniond(best(0), best(1), best(2), best(3)).normalized().matrix();
    RotationFit fit;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) fit.rotation[column][row] = r(row, column);
    fit.agreement = solver.eigenvalues()(3);
    fit.mirrored = -solver.eigenvalues()(0);
    fit.margin = solver.eigenvalues()(3) - solver.eigenvalues()(2);
    return fit;
}

}  // namespace interleaf
