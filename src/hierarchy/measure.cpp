#include "hierarchy/measure.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <functional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace interleaf {

namespace {

/// An edge as traversed by one triangle: its ends in ascending order, and whether the triangle traverses it
/// downwards.
struct DirectedEdge {
    Index low;
    Index high;
    bool downwards;
    auto operator<=>(const DirectedEdge&) const = default;

    bool has_ends_of(const DirectedEdge& other) const { return low == other.low && high == other.high; }
};

std::vector<DirectedEdge> sorted_edges(std::span<const Triangle> triangles) {
    std::vector<DirectedEdge> edges;
    edges.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index from = triangle[k];
            const Index to = triangle[(k + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), from > to});
        }
    std::sort(edges.begin(), edges.end());
    return edges;
}

}  // namespace

float Box::diagonal() const {
    return glm::distance(min, max);
}

glm::vec3 Box::center() const {
    return min + (max - min) / 2.0F;
}

Extent extent_of(const Box& box) {
    return {box, box.diagonal() / 2};
}

Extent extent_of(std::span<const std::span<const glm::vec3>> parts) {
    std::vector<glm::vec3> corners;
    for (const auto& part : parts) {
        if (part.empty()) continue;
        const Box box = bounding_box(part);
        corners.insert(corners.end(), {box.min, box.max});
    }
    Extent extent{bounding_box(corners), 0};
    const glm::vec3 center = extent.box.center();
    for (const auto& part : parts)
        for (const glm::vec3& position : part)
            extent.radius = std::max(extent.radius, glm::distance(position, center));
    return extent;
}

Extent extent_of(std::span<const glm::vec3> positions) {
    return extent_of(std::span(&positions, 1));
}

Box bounding_box(std::span<const glm::vec3> positions) {
    if (positions.empty()) return {};
    Box box{positions[0], positions[0]};
    for (const glm::vec3& p : positions) {
        box.min = glm::min(box.min, p);
        box.max = glm::max(box.max, p);
    }
    return box;
}

Measures measure(std::span<const Triangle> triangles, std::span<const glm::vec3> positions) {
    Measures result{0, 0, 180};
    const glm::dvec3 center =
        positions.empty() ? glm::vec3(0) : positions[0];  // keeps the volume's terms small
    for (const auto& [i, j, k] : triangles) {
        const std::array<glm::dvec3, 3> p = {glm::dvec3(positions[i]) - center,
                                             glm::dvec3(positions[j]) - center,
                                             glm::dvec3(positions[k]) - center};
        const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
        const double doubled_area = glm::length(normal);
        result.area += doubled_area / 2;
        result.volume += glm::dot(p[0], normal) / 6;
        for (std::size_t c = 0; c < 3; ++c) {
            const double cosine = glm::dot(p[(c + 1) % 3] - p[c], p[(c + 2) % 3] - p[c]);
            result.min_angle = std::min(result.min_angle, glm::degrees(std::atan2(doubled_area, cosine)));
        }
    }
    return result;
}

int euler_number(std::span<const Triangle> triangles) {
    std::vector<Index> vertices;
    vertices.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles)
        vertices.insert(vertices.end(), triangle.begin(), triangle.end());
    std::sort(vertices.begin(), vertices.end());
    const auto vertex_count = std::unique(vertices.begin(), vertices.end()) - vertices.begin();

    std::vector<DirectedEdge> edges = sorted_edges(triangles);
    const auto edge_count =
        std::unique(edges.begin(), edges.end(), std::mem_fn(&DirectedEdge::has_ends_of)) - edges.begin();
    return static_cast<int>(vertex_count - edge_count + static_cast<std::ptrdiff_t>(triangles.size()));
}

bool is_closed_manifold(std::span<const Triangle> triangles) {
    const std::vector<DirectedEdge> edges = sorted_edges(triangles);
    if (edges.size() % 2 != 0) return false;
    for (std::size_t e = 0; e < edges.size(); e += 2) {
        if (!edges[e].has_ends_of(edges[e + 1]) || edges[e].downwards || !edges[e + 1].downwards)
            return false;
        if (e > 0 && edges[e].has_ends_of(edges[e - 1])) return false;
    }
    return true;
}

}  // namespace interleaf
