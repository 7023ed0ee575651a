#include "fit/correspondence/surface_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/sphere_map/rest_shape.h"

namespace interleaf {
namespace {

std::vector<double> vertex_areas(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions) {
    std::vector<double> areas(positions.size(), 0.0);
    for (const auto& [a, b, c] : triangles) {
        const double third =
            glm::length(glm::cross(positions[b] - positions[a], positions[c] - positions[a])) / 6;
        for (const Index vertex : {a, b, c}) areas[vertex] += third;
    }
    return areas;
}

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

/// Edges of a mesh, and the shortest ways across pairs of triangles, by vertex.
class FeatureGraph {
  public:
    FeatureGraph(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions)
        : links_(positions.size()) {
        const HalfEdgeMesh mesh(static_cast<Index>(positions.size()), triangles);
        for (Index h = 0; h < 3 * mesh.triangle_capacity(); ++h) {
            const Index a = mesh.origin(h);
            const Index b = mesh.target(h);
            if (a > b) continue;
            link(a, b, glm::distance(positions[a], positions[b]));
            const Index c = mesh.origin(HalfEdgeMesh::previous(h));
            const Index d = mesh.origin(HalfEdgeMesh::previous(mesh.twin(h)));
            link_across(c, d, positions[a], positions[b], positions[c], positions[d]);
        }
    }

    /// The distances of all vertices from \p source.
    std::vector<double> distances_from(Index source, ProgressMeter& meter) const {
        using Reached = std::pair<double, Index>;
        std::vector<double> distances(links_.size(), std::numeric_limits<double>::infinity());
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
        distances[source] = 0;
        queue.push({0, source});
        while (!queue.empty()) {
            const auto [distance, vertex] = queue.top();
            queue.pop();
            meter.step(4);
            if (distance > distances[vertex]) continue;
            for (const Link& link : links_[vertex])
                if (distance + link.length < distances[link.to]) {
                    distances[link.to] = distance + link.length;
                    queue.push({distances[link.to], link.to});
                }
        }
        return distances;
    }

  private:
    struct Link {
        Index to;
        double length;
    };

    void link(Index a, Index b, double length) {
        links_[a].push_back({b, length});
        links_[b].push_back({a, length});
    }

    /// Links c and d on the two sides of the edge from \p a to \p b, if the straight way in the unfolded pair
    /// of triangles crosses the edge.
    void link_across(Index c_index, Index d_index, const glm::dvec3& a, const glm::dvec3& b,
                     const glm::dvec3& c, const glm::dvec3& d) {
        const double length = glm::distance(a, b);
        if (!(length > 0)) return;
        const glm::dvec3 along = (b - a) / length;
        const double c_along = glm::dot(c - a, along);
        const double d_along = glm::dot(d - a, along);
        const double c_away = glm::length(c - a - c_along * along);
        const double d_away = glm::length(d - a - d_along * along);
        const double away = c_away + d_away;
        if (!(away > 0)) return;
        const double crossing = c_along + (d_along - c_along) * c_away / away;
        const double shift = c_along - d_along;
        if (crossing > 0 && crossing < length) link(c_index, d_index, std::sqrt(shift * shift + away * away));
    }

    std::vector<std::vector<Link>> links_;
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
                                ProgressMeter& meter) {
    constexpr std::size_t sources = 32;
    const FeatureGraph graph(triangles, positions);
    const std::vector<double> areas = vertex_areas(triangles, positions);
    const auto farthest = [](const std::vector<double>& distances) {
        return static_cast<Index>(std::max_element(distances.begin(), distances.end()) - distances.begin());
    };
    std::vector<double> nearest(positions.size(), std::numeric_limits<double>::infinity());
    std::vector<std::size_t> nearest_source(positions.size(), 0);
    std::vector<std::vector<double>> distances;
    Index source = farthest(graph.distances_from(0, meter));
    for (std::size_t i = 0; i < sources; ++i) {
        distances.push_back(graph.distances_from(source, meter));
        for (std::size_t v = 0; v < nearest.size(); ++v)
            if (distances[i][v] < nearest[v]) {
                nearest[v] = distances[i][v];
                nearest_source[v] = i;
            }
        source = farthest(nearest);
    }
    std::vector<double> weights(sources, 0.0);
    for (std::size_t v = 0; v < areas.size(); ++v) weights[nearest_source[v]] += areas[v];
    std::vector<double> mean(positions.size(), 0.0);
    for (std::size_t i = 0; i < sources; ++i)
        for (std::size_t v = 0; v < mean.size(); ++v) mean[v] += weights[i] * distances[i][v];
    const auto [least, most] = std::minmax_element(mean.begin(), mean.end());
    const double low = *least;
    const double range = *most - low;
    for (double& value : mean) value = range > 0 ? (value - low) / range : 0;
    return mean;
}

}  // namespace interleaf
