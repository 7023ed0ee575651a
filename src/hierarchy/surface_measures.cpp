#include "hierarchy/surface_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace interleaf {
namespace {

/// Corners sharper than about 0.06 degrees count as this sharp, so that slivers stay finite.
constexpr double max_cotangent = 1000;

/// The sums at a vertex of which its curvature is made.
struct VertexSums {
    glm::dvec3 laplacian{0};  ///< of the position, times twice the area
    glm::dvec3 normal{0};     ///< not normalized
    double area = 0;          ///< mixed area around the vertex

    /// The number of the next vertex less that of the last one, summed over the triangles here. In a closed
    /// fan each neighbor comes once as either, so the sum is 0; on the boundary two different neighbors remain.
    std::int64_t open_ends = 0;
};

double mean_curvature(const VertexSums& sums) {
    if (!(sums.area > 0)) return 0;
    const double size = glm::length(sums.laplacian) / (4 * sums.area);
    return glm::dot(sums.laplacian, sums.normal) > 0 ? -size : size;
}

/// The corners of a triangle, and what they give to their vertices.
struct CornerTerms {
    std::array<glm::dvec3, 3> places;
    std::array<double, 3> cosines{};  ///< times the lengths of the edges beside the corner
    std::array<double, 3> cotangents{};
    glm::dvec3 normal;
    double area;

    CornerTerms(const Triangle& triangle, std::span<const glm::vec3> positions)
        : places{positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]},
          normal(glm::cross(places[1] - places[0], places[2] - places[0])),
          area(glm::length(normal) / 2) {
        for (std::size_t k = 0; k < 3; ++k) {
            cosines.at(k) = glm::dot(edge(k, (k + 1) % 3), edge(k, (k + 2) % 3));
            if (area > 0)
                cotangents.at(k) = std::clamp(cosines.at(k) / (2 * area), -max_cotangent, max_cotangent);
        }
    }

    glm::dvec3 edge(std::size_t from, std::size_t to) const { return places.at(to) - places.at(from); }

    /// The part of the area that is nearest to corner \p k; where an angle is obtuse, a half or a quarter.
    double area_at(std::size_t k) const {
        if (cosines.at(k) < 0) return area / 2;
        const std::size_t next = (k + 1) % 3;
        const std::size_t last = (k + 2) % 3;
        if (cosines.at(next) < 0 || cosines.at(last) < 0) return area / 4;
        const glm::dvec3 to_next = edge(k, next);
        const glm::dvec3 to_last = edge(k, last);
        return (glm::dot(to_next, to_next) * cotangents.at(last) +
                glm::dot(to_last, to_last) * cotangents.at(next)) /
               8;
    }
};

std::vector<VertexSums> vertex_sums(std::span<const Triangle> triangles,
                                    std::span<const glm::vec3> positions) {
    std::vector<VertexSums> sums(positions.size());
    for (const Triangle& triangle : triangles) {
        const CornerTerms terms(triangle, positions);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const std::size_t last = (k + 2) % 3;
            VertexSums& here = sums[triangle[k]];
            here.open_ends += std::int64_t{triangle[next]} - std::int64_t{triangle[last]};
            here.normal += terms.normal;
            here.area += terms.area_at(k);
            // the angle at k weighs the edge from the next corner to the last one
            const glm::dvec3 along = terms.cotangents.at(k) * terms.edge(next, last);
            sums[triangle[next]].laplacian += along;
            sums[triangle[last]].laplacian -= along;
        }
    }
    return sums;
}

/// Gives each vertex of the boundary the mean of its neighbors inside.
void take_inner_neighbors(std::span<const Triangle> triangles, const std::vector<VertexSums>& sums,
                          std::vector<float>& curvatures) {
    std::vector<unsigned> counts(sums.size(), 0);
    for (const Triangle& triangle : triangles)
        for (const Index vertex : triangle)
            for (const Index neighbor : triangle) {
                if (sums[vertex].open_ends == 0 || sums[neighbor].open_ends != 0) continue;
                curvatures[vertex] += curvatures[neighbor];
                ++counts[vertex];
            }
    for (std::size_t v = 0; v < counts.size(); ++v)
        if (counts[v] > 0) curvatures[v] /= static_cast<float>(counts[v]);
}

}  // namespace

std::vector<float> smallest_angles(std::span<const Triangle> triangles,
                                   std::span<const glm::vec3> positions) {
    std::vector<float> angles;
    angles.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
        std::array<glm::dvec3, 3> edges;  // opposite each corner
        for (std::size_t k = 0; k < 3; ++k)
            edges.at(k) =
                glm::dvec3(positions[triangle[(k + 2) % 3]]) - glm::dvec3(positions[triangle[(k + 1) % 3]]);
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
    const std::vector<VertexSums> sums = vertex_sums(triangles, positions);
    std::vector<float> curvatures;
    curvatures.reserve(sums.size());
    for (const VertexSums& each : sums)
        curvatures.push_back(each.open_ends == 0 ? static_cast<float>(mean_curvature(each)) : 0.0F);
    take_inner_neighbors(triangles, sums, curvatures);
    return curvatures;
}

std::vector<float> distances(std::span<const glm::vec3> before, std::span<const glm::vec3> after) {
    std::vector<float> lengths;
    lengths.reserve(after.size());
    for (std::size_t v = 0; v < after.size(); ++v) lengths.push_back(glm::distance(before[v], after[v]));
    return lengths;
}

}  // namespace interleaf
