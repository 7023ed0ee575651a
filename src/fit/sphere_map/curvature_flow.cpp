#include "fit/sphere_map/curvature_flow.h"

#include <cmath>

#include <Eigen/Sparse>
#include <glm/geometric.hpp>

#include "fit/sphere_map/progressive_map.h"
#include "fit/sphere_map/relaxation.h"
#include "fit/sphere_map/rest_shape.h"

namespace interleaf {
namespace {

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Stiffness = Eigen::SparseMatrix<double, Eigen::RowMajor>;

glm::dvec3 row(const Points& points, Index vertex) {
    return {points(vertex, 0), points(vertex, 1), points(vertex, 2)};
}

/// The cotangent Laplacian of the original surface. The flow keeps it, and so has no singularities.
Stiffness stiffness_of(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions, double blend) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12 * std::size_t(mesh.triangle_capacity()));
    for (Index triangle = 0; triangle < mesh.triangle_capacity(); ++triangle) {
        const Index corner = 3 * triangle;
        const auto cotangents =
            rest_cotangents(positions[mesh.origin(corner)], positions[mesh.origin(corner + 1)],
                            positions[mesh.origin(corner + 2)], blend);
        for (Index k = 0; k < 3; ++k) {
            const auto from = int(mesh.origin(corner + k));
            const auto to = int(mesh.target(corner + k));
            const double weight = cotangents[k] / 2;
            entries.insert(
                entries.end(),
                {{from, from, weight}, {to, to, weight}, {from, to, -weight}, {to, from, -weight}});
        }
    }
    Stiffness matrix(mesh.vertex_capacity(), mesh.vertex_capacity());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// Per vertex, a third of the area of its triangles.
Eigen::VectorXd lumped_masses(const HalfEdgeMesh& mesh, const Points& points) {
    Eigen::VectorXd masses = Eigen::VectorXd::Zero(points.rows());
    for (Index triangle = 0; triangle < mesh.triangle_capacity(); ++triangle) {
        const Index corner = 3 * triangle;
        const glm::dvec3 a = row(points, mesh.origin(corner));
        const glm::dvec3 b = row(points, mesh.origin(corner + 1));
        const glm::dvec3 c = row(points, mesh.origin(corner + 2));
        const double third = glm::length(glm::cross(b - a, c - a)) / 6;
        for (Index k = 0; k < 3; ++k) masses[mesh.origin(corner + k)] += third;
    }
    return masses;
}

/// Solves (masses + step * stiffness) x = masses * x by conjugate gradients, starting from x, for all
/// coordinates at once.
void flow_once(Points& x, const Eigen::VectorXd& masses, const Stiffness& stiffness, double step,
               const auto& report) {
    constexpr double tolerance = 1e-7;
    constexpr int max_iterations = 1000;
    const auto apply = [&](const Points& p) -> Points {
        return masses.asDiagonal() * p + step * (stiffness * p);
    };
    const Eigen::VectorXd inverse_diagonal = (masses + step * stiffness.diagonal()).cwiseInverse();
    const Points right = masses.asDiagonal() * x;
    Points residual = right - apply(x);
    Points direction = inverse_diagonal.asDiagonal() * residual;
    double energy = residual.cwiseProduct(direction).sum();
    const double enough = tolerance * right.norm();
    for (int i = 0; i < max_iterations && residual.norm() > enough && energy > 0; ++i) {
        report();
        const Points image = apply(direction);
        const double along = energy / direction.cwiseProduct(image).sum();
        x += along * direction;
        residual -= along * image;
        const Points preconditioned = inverse_diagonal.asDiagonal() * residual;
        const double next_energy = residual.cwiseProduct(preconditioned).sum();
        direction = preconditioned + next_energy / energy * direction;
        energy = next_energy;
    }
}

}  // namespace

std::vector<glm::dvec3> flow_to_sphere(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
                                       const CurvatureFlowOptions& options, ProgressMeter& meter) {
    Points x(positions.size(), 3);
    for (Index i = 0; i < mesh.vertex_capacity(); ++i)
        x.row(i) << positions[i].x, positions[i].y, positions[i].z;
    const Stiffness stiffness = stiffness_of(mesh, positions, options.blend);
    const auto center = [&](const Eigen::VectorXd& masses) {
        const Eigen::RowVector3d middle = (masses.transpose() * x) / masses.sum();
        x.rowwise() -= middle;
    };
    for (int step = 0; step < options.steps; ++step) {
        const double part = double(step) / options.steps;
        Eigen::VectorXd masses = lumped_masses(mesh, x);
        center(masses);
        x /= std::sqrt(masses.sum());
        masses /= masses.sum();
        masses.array() += 1e-6 / double(positions.size());  // where the surface has no area
        flow_once(x, masses, stiffness, options.time_step, [&] { meter.enter("curvature flow", part); });
    }
    center(lumped_masses(mesh, x));
    std::vector<glm::dvec3> points;
    points.reserve(positions.size());
    for (Index i = 0; i < mesh.vertex_capacity(); ++i) points.push_back(glm::normalize(row(x, i)));
    return points;
}

std::vector<glm::dvec3> map_by_curvature_flow(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
                                              const CurvatureFlowOptions& options, ProgressMeter& meter) {
    constexpr int max_sweeps = 100;
    std::vector<glm::dvec3> points = flow_to_sphere(mesh, positions, options, meter);
    const std::vector<double> areas = solid_angles_wanted(mesh, positions);
    Relaxation relaxation(mesh, positions, areas, points);
    relaxation.update_shapes(options.blend);
    if (relaxation.untangle(max_sweeps, meter)) relaxation.sweep(max_sweeps, meter);
    return points;
}

}  // namespace interleaf
