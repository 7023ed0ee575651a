#include "hierarchy/rotation_fit.h"

#include <cstddef>

#include <Eigen/Eigenvalues>
#include <glm/matrix.hpp>

namespace interleaf {

RotationFit fit_rotation(const glm::dmat3& products) {
    const auto s = [&](int i, int j) { return products[j][i]; };
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
    fit.quaternion = {best(0), best(1), best(2), best(3)};
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) fit.rotation[column][row] = r(row, column);
    fit.agreement = solver.eigenvalues()(3);
    fit.mirrored = -solver.eigenvalues()(0);
    fit.margin = solver.eigenvalues()(3) - solver.eigenvalues()(2);
    return fit;
}

RotationFit fit_rotation(std::span<const glm::dvec3> from, std::span<const glm::dvec3> to) {
    glm::dmat3 products(0);
    for (std::size_t v = 0; v < from.size(); ++v) products += glm::outerProduct(from[v], to[v]);
    return fit_rotation(products);
}

}  // namespace interleaf
