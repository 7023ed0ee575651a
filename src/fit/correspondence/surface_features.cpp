#include "fit/correspondence/surface_features.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "fit/mesh/mean_distances.h"
#include "fit/mesh/surface_graph.h"
#include "fit/sphere_map/rest_shape.h"

namespace interleaf {
namespace {

/// The matrix masses + time * stiffness of linear elements, and the solution of its equations by conjugate
/// gradients. Sums run in the order of vertices, so that they are the same on every machine.
class HeatStep {
  public:
    HeatStep(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions, double time)
        : triangles_(triangles), masses_(vertex_areas(triangles, positions)) {
        constexpr double blend = 0.02;  // towards equilateral, for needles
        constexpr double least = 1e-9;
        for (double& mass : masses_) mass = std::max(mass, least);
        diagonal_ = masses_;
        weights_.reserve(triangles.size());
        for (const auto& [a, b, c] : triangles) {
            std::array<double, 3> weights = rest_cotangents(positions[a], positions[b], positions[c], blend);
            for (double& weight : weights) weight *= time / 2;  // of the sides a b, b c, c a
            diagonal_[a] += weights[0] + weights[2];
            diagonal_[b] += weights[0] + weights[1];
            diagonal_[c] += weights[1] + weights[2];
            weights_.push_back(weights);
        }
    }

    std::vector<glm::dvec3> solve(std::span<const glm::dvec3> field, ProgressMeter& meter) const {
        constexpr double tolerance = 1e-6;
        constexpr int max_iterations = 300;
        std::vector<glm::dvec3> x(field.begin(), field.end());
        std::vector<glm::dvec3> image = apply(x);
        std::vector<glm::dvec3> residual(x.size());
        for (std::size_t v = 0; v < x.size(); ++v) residual[v] = masses_[v] * field[v] - image[v];
        std::vector<glm::dvec3> direction = preconditioned(residual);
        double energy = inner(residual, direction);
        const double enough = tolerance * tolerance * energy_of(field);
        for (int i = 0; i < max_iterations && energy > enough; ++i) {
            meter.step(x.size());
            image = apply(direction);
            const double along = energy / inner(direction, image);
            for (std::size_t v = 0; v < x.size(); ++v) {
                x[v] += along * direction[v];
                residual[v] -= along * image[v];
            }
            const std::vector<glm::dvec3> next = preconditioned(residual);
            const double next_energy = inner(residual, next);
            for (std::size_t v = 0; v < x.size(); ++v)
                direction[v] = next[v] + next_energy / energy * direction[v];
            energy = next_energy;
        }
        return x;
    }

  private:
    std::vector<glm::dvec3> apply(const std::vector<glm::dvec3>& x) const {
        std::vector<glm::dvec3> y(x.size());
        for (std::size_t v = 0; v < x.size(); ++v) y[v] = diagonal_[v] * x[v];
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            const auto& [a, b, c] = triangles_[t];
            const auto& [ab, bc, ca] = weights_[t];
            y[a] -= ab * x[b] + ca * x[c];
            y[b] -= ab * x[a] + bc * x[c];
            y[c] -= bc * x[b] + ca * x[a];
        }
        return y;
    }

    std::vector<glm::dvec3> preconditioned(const std::vector<glm::dvec3>& x) const {
        std::vector<glm::dvec3> y(x.size());
        for (std::size_t v = 0; v < x.size(); ++v) y[v] = x[v] / diagonal_[v];
        return y;
    }

    static double inner(const std::vector<glm::dvec3>& x, const std::vector<glm::dvec3>& y) {
        double sum = 0;
        for (std::size_t v = 0; v < x.size(); ++v) sum += glm::dot(x[v], y[v]);
        return sum;
    }

    double energy_of(std::span<const glm::dvec3> field) const {
        double sum = 0;
        for (std::size_t v = 0; v < field.size(); ++v)
            sum += masses_[v] * masses_[v] / diagonal_[v] * glm::dot(field[v], field[v]);
        return sum;
    }

    std::span<const Triangle> triangles_;
    std::vector<double> masses_;
    std::vector<double> diagonal_;
    std::vector<std::array<double, 3>> weights_;
};

}  // namespace

std::vector<glm::dvec3> vertex_normals(std::span<const Triangle> triangles,
                                       std::span<const glm::dvec3> positions) {
    std::vector<glm::dvec3> normals(positions.size(), glm::dvec3(0));
    for (const auto& [a, b, c] : triangles) {
        const glm::dvec3 normal = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
        for (const Index vertex : {a, b, c}) normals[vertex] += normal;
    }
    for (glm::dvec3& normal : normals) {
        const double length = glm::length(normal);
        normal = length > 0 ? normal / length : glm::dvec3(0);
    }
    return normals;
}

std::vector<glm::dvec3> smoothed_directions(std::span<const Triangle> triangles,
                                            std::span<const glm::dvec3> positions,
                                            std::span<const glm::dvec3> field, double radius,
                                            ProgressMeter& meter) {
    constexpr double least = 1e-9;
    std::vector<glm::dvec3> smooth = HeatStep(triangles, positions, radius * radius).solve(field, meter);
    for (glm::dvec3& direction : smooth) {
        const double length = glm::length(direction);
        if (length > least) direction /= length;
    }
    return smooth;
}

std::vector<double> outwardness(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions,
                                double begin, double end, ProgressMeter& meter) {
    constexpr std::size_t bases = 32;
    const SurfaceGraph graph(triangles, positions);
    std::vector<double> mean =
        mean_distances(graph, vertex_areas(triangles, positions), bases, begin, end, meter);
    const auto [least, most] = std::minmax_element(mean.begin(), mean.end());
    const double low = *least;
    const double range = *most - low;
    for (double& value : mean) value = range > 0 ? (value - low) / range : 0;
    return mean;
}

}  // namespace interleaf
