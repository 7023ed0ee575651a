#include "hierarchy/surface_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace interleaf {
namespace {

/// Edge vectors of a triangle, from the corner after each corner to the one before it.
std::array<glm::dvec3, 3> opposite_edges(const Triangle& triangle, std::span<const glm::vec3> positions) {
    std::array<glm::dvec3, 3> edges;
    for (std::size_t k = 0; k < 3; ++k)
        edges.at(k) =
            glm::dvec3(positions[triangle[(k + 2) % 3]]) - glm::dvec3(positions[triangle[(k + 1) % 3]]);
    return edges;
}

/// Unit normals at the vertices, with the weights of Max (1999): exact where the vertices around lie on a
/// sphere, however they are joined. Zero where there is no area.
std::vector<glm::dvec3> sphere_normals(std::span<const Triangle> triangles,
                                       std::span<const glm::vec3> positions) {
    std::vector<glm::dvec3> normals(positions.size(), glm::dvec3(0));
    for (const Triangle& triangle : triangles) {
        const auto edges = opposite_edges(triangle, positions);
        const glm::dvec3 normal = glm::cross(edges[0], edges[1]);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3& before = edges.at((k + 1) % 3);
            const glm::dvec3& after = edges.at((k + 2) % 3);
            const double weight = glm::dot(before, before) * glm::dot(after, after);
            if (weight > 0) normals[triangle[k]] += normal / weight;
        }
    }
    for (glm::dvec3& normal : normals)
        if (const double length = glm::length(normal); length > 0) normal /= length;
    return normals;
}

/// Per vertex, whether it is on the boundary. The number of the next vertex less that of the last one, summed over
/// the triangles at a vertex, is 0 in a closed fan, where each neighbor comes once as either.
std::vector<bool> on_boundary(std::span<const Triangle> triangles, std::size_t vertex_count) {
    std::vector<std::int64_t> sums(vertex_count, 0);
    for (const Triangle& triangle : triangles)
        for (std::size_t k = 0; k < 3; ++k)
            sums[triangle[k]] += std::int64_t{triangle[(k + 1) % 3]} - std::int64_t{triangle[(k + 2) % 3]};
    std::vector<bool> on_it;
    on_it.reserve(vertex_count);
    for (const std::int64_t sum : sums) on_it.push_back(sum != 0);
    return on_it;
}

struct AreaMean {
    double integral = 0;
    double area = 0;
    double mean() const { return area > 0 ? integral / area : 0; }
};

/// Half the divergence of \p normals, over the triangles at each vertex that do not touch the boundary: a fan that
/// is open has a wrong normal.
std::vector<AreaMean> half_divergences(std::span<const Triangle> triangles,
                                       std::span<const glm::vec3> positions,
                                       std::span<const glm::dvec3> normals, const std::vector<bool>& at_end) {
    std::vector<AreaMean> means(positions.size());
    for (const Triangle& triangle : triangles) {
        const auto edges = opposite_edges(triangle, positions);
        const glm::dvec3 normal = glm::cross(edges[0], edges[1]);
        const double twice_area = glm::length(normal);
        if (!(twice_area > 0) || std::ranges::any_of(triangle, [&](Index v) { return at_end[v]; })) continue;
        // the gradient of a coordinate is that edge, turned by a right angle, over twice the area
        double divergence = 0;
        for (std::size_t k = 0; k < 3; ++k)
            divergence += glm::dot(normals[triangle[k]], glm::cross(normal / twice_area, edges.at(k)));
        for (const Index vertex : triangle) {
            means[vertex].integral += divergence / 4;
            means[vertex].area += twice_area / 2;
        }
    }
    return means;
}

/// Gives each vertex without a mean that of its neighbors with one.
void take_neighbors(std::span<const Triangle> triangles, std::vector<AreaMean>& means) {
    const std::vector<AreaMean> before = means;
    for (const Triangle& triangle : triangles)
        for (const Index vertex : triangle)
            for (const Index neighbor : triangle) {
                if (before[vertex].area > 0) continue;
                means[vertex].integral += before[neighbor].integral;
                means[vertex].area += before[neighbor].area;
            }
}

}  // namespace

std::vector<float> smallest_angles(std::span<const Triangle> triangles,
                                   std::span<const glm::vec3> positions) {
    std::vector<float> angles;
    angles.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
        const auto edges = opposite_edges(triangle, positions);
        const double area = glm::length(glm::cross(edges[0], edges[1]));
        double smallest = 60;
        for (std::size_t k = 0; k < 3; ++k) {
            const double cosine = -glm::dot(edges.at((k + 1) % 3), edges.at((k + 2) % 3));
            const double angle = area > 0 ? std::atan2(area, cosine) : 0;
            smallest = std::min(smallest, glm::degrees(angle));
        }
        angles.push_back(static_cast<float>(smallest));
    }
    return angles;
}

std::vector<float> mean_curvatures(std::span<const Triangle> triangles,
                                   std::span<const glm::vec3> positions) {
    const std::vector<glm::dvec3> normals = sphere_normals(triangles, positions);
    const std::vector<bool> at_end = on_boundary(triangles, positions.size());
    std::vector<AreaMean> means = half_divergences(triangles, positions, normals, at_end);
    take_neighbors(triangles, means);  // the boundary those inside
    take_neighbors(triangles, means);  // corners those beside them
    std::vector<float> curvatures;
    curvatures.reserve(means.size());
    for (const AreaMean& each : means) curvatures.push_back(static_cast<float>(each.mean()));
    return curvatures;
}

std::vector<float> distances(std::span<const glm::vec3> before, std::span<const glm::vec3> after) {
    std::vector<float> lengths;
    lengths.reserve(after.size());
    constexpr double most = std::numeric_limits<float>::max();
    for (std::size_t v = 0; v < after.size(); ++v)
        lengths.push_back(
            static_cast<float>(std::min(glm::distance(glm::dvec3(before[v]), glm::dvec3(after[v])), most)));
    return lengths;
}

}  // namespace interleaf
