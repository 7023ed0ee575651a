#include "fit/mesh/surface_graph.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/mesh/half_edge_mesh.h"

namespace interleaf {
namespace {

/// A path between two vertices.
struct Path {
    Index from;
    Index to;
    double length;
};

/// The distance of \p c and \p d over the edge a b, with the triangles at the edge laid flat; 0 if the straight
/// line misses the edge.
double flat_distance(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    const double length = glm::distance(a, b);
    if (!(length > 0)) return 0;
    const auto along = [&](const glm::dvec3& point) { return glm::dot(point - a, b - a) / length; };
    const auto height = [&](const glm::dvec3& point) {
        return glm::length(glm::cross(point - a, b - a)) / length;
    };
    const double height_of_both = height(c) + height(d);
    if (!(height_of_both > 0)) return 0;
    const double crossing = along(c) + (along(d) - along(c)) * height(c) / height_of_both;
    if (!(crossing > 0 && crossing < length)) return 0;
    const double offset = along(d) - along(c);
    return std::sqrt(offset * offset + height_of_both * height_of_both);
}

std::vector<Path> paths_over(std::span<const Triangle> triangles, std::span<const glm::dvec3> at) {
    const HalfEdgeMesh half_edges(static_cast<Index>(at.size()), triangles);
    std::vector<Path> paths;
    paths.reserve(3 * triangles.size());
    for (Index half_edge = 0; half_edge < 3 * triangles.size(); ++half_edge) {
        const Index twin = half_edges.twin(half_edge);
        if (twin < half_edge) continue;
        const Index a = half_edges.origin(half_edge);
        const Index b = half_edges.target(half_edge);
        const Index c = half_edges.origin(HalfEdgeMesh::previous(half_edge));
        const Index d = half_edges.origin(HalfEdgeMesh::previous(twin));
        paths.push_back({a, b, glm::distance(at[a], at[b])});
        if (const double flat = flat_distance(at[a], at[b], at[c], at[d]); flat > 0)
            paths.push_back({c, d, flat});
    }
    return paths;
}

}  // namespace

SurfaceGraph::SurfaceGraph(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions)
    : begin_(positions.size() + 1) {
    const std::vector<Path> paths = paths_over(triangles, positions);
    for (const Path& path : paths) {
        ++begin_[path.from + 1];
        ++begin_[path.to + 1];
    }
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    links_.resize(2 * paths.size());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (const Path& path : paths) {
        links_[next[path.from]++] = {path.to, path.length};
        links_[next[path.to]++] = {path.from, path.length};
    }
}

std::vector<double> SurfaceGraph::distances_from(Index source) const {
    std::vector<double> distances(vertex_count(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    distances[source] = 0;
    open.emplace(0, source);
    while (!open.empty()) {
        const auto [distance, vertex] = open.top();
        open.pop();
        if (distance > distances[vertex]) continue;
        for (const Link& link : links_of(vertex)) {
            const double farther = distance + link.length;
            if (farther >= distances[link.vertex]) continue;
            distances[link.vertex] = farther;
            open.emplace(farther, link.vertex);
        }
    }
    return distances;
}

}  // namespace interleaf
