#include "fit/landmarks/proposals.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>

#include <glm/geometric.hpp>

#include "fit/landmarks/surface_graph.h"
#include "fit/mesh/progress_meter.h"

namespace interleaf {
namespace {

/// Number of vertices from which distances are measured: many on a small mesh, fewer where each takes long.
std::size_t base_count(std::size_t vertices) {
    constexpr std::size_t fewest = 12;
    constexpr std::size_t most = 60;
    constexpr std::size_t measured = 6'000'000;
    return std::clamp(measured / vertices, fewest, most);
}

std::vector<double> areas_around_vertices(const SurfaceMesh& mesh) {
    std::vector<double> areas(mesh.positions.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 corner = mesh.positions[a];
        const double area =
            glm::length(glm::cross(mesh.positions[b] - corner, mesh.positions[c] - corner)) / 6;
        for (const Index vertex : {a, b, c}) areas[vertex] += area;
    }
    return areas;
}

std::size_t largest_of(std::span<const double> values) {
    return std::size_t(std::ranges::max_element(values) - values.begin());
}

/// Per vertex, the mean distance of all other points, by area. Each base stands for the area that is nearer to
/// it than to other bases; the next base is the vertex farthest from all before it.
std::vector<double> mean_distances(const SurfaceMesh& mesh, const SurfaceGraph& graph, ProgressMeter& meter) {
    const std::size_t count = graph.vertex_count();
    const std::vector<double> area = areas_around_vertices(mesh);
    std::vector<std::vector<float>> distances;
    std::vector<double> nearest(count, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> nearest_base(count);
    const std::size_t bases = std::min(count, base_count(count));
    for (Index next = 0; distances.size() < bases; next = static_cast<Index>(largest_of(nearest))) {
        meter.enter("measuring distances", double(distances.size()) / double(bases));
        const std::vector<double> from_base = graph.distances_from(next);
        for (std::size_t v = 0; v < count; ++v) {
            if (from_base[v] >= nearest[v]) continue;
            nearest[v] = from_base[v];
            nearest_base[v] = distances.size();
        }
        distances.emplace_back(from_base.begin(), from_base.end());
    }
    std::vector<double> weight(bases);
    for (std::size_t v = 0; v < count; ++v) weight[nearest_base[v]] += area[v];
    const double whole = std::accumulate(weight.begin(), weight.end(), 0.0);
    std::vector<double> mean(count);
    for (std::size_t base = 0; base < bases; ++base)
        for (std::size_t v = 0; v < count; ++v) mean[v] += weight[base] / whole * double(distances[base][v]);
    return mean;
}

/// The local maxima of \p height with their persistence, in units of the height. Vertices are added from the
/// highest to the lowest; where two parts meet, the lower maximum ends.
std::vector<Extremity> maxima_of(std::span<const double> height, const SurfaceGraph& graph) {
    std::vector<Index> order(height.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::stable_sort(order, [&](Index a, Index b) { return height[a] > height[b]; });
    std::vector<Index> parent(height.size(), no_index);
    const auto top_of = [&](Index vertex) {
        while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
        return vertex;
    };
    std::vector<Extremity> maxima = {{order.front(), height[order.front()] - height[order.back()]}};
    for (const Index vertex : order) {
        parent[vertex] = vertex;
        for (const SurfaceGraph::Link& link : graph.links_of(vertex)) {
            if (parent[link.vertex] == no_index) continue;
            Index higher = top_of(link.vertex);
            Index lower = top_of(vertex);
            if (higher == lower) continue;
            if (height[higher] < height[lower]) std::swap(higher, lower);
            if (height[lower] > height[vertex]) maxima.push_back({lower, height[lower] - height[vertex]});
            parent[lower] = higher;
        }
    }
    return maxima;
}

}  // namespace

std::vector<Extremity> find_extremities(const SurfaceMesh& mesh, const ProposalOptions& options,
                                        const Progress& progress) {
    ProgressMeter meter(progress);
    const SurfaceGraph graph(mesh);
    const std::vector<double> height = mean_distances(mesh, graph, meter);
    std::vector<Extremity> extremities = maxima_of(height, graph);
    const double range = extremities.front().persistence;
    for (Extremity& each : extremities) each.persistence = range > 0 ? each.persistence / range : 1;
    std::ranges::stable_sort(
        extremities, [](const Extremity& a, const Extremity& b) { return a.persistence > b.persistence; });
    std::erase_if(extremities, [&](const Extremity& each) { return each.persistence < options.persistence; });
    if (extremities.size() > options.max_count) extremities.resize(options.max_count);
    return extremities;
}

}  // namespace interleaf
