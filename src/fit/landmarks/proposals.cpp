#include "fit/landmarks/proposals.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>

#include "fit/mesh/mean_distances.h"
#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_graph.h"

namespace interleaf {
namespace {

/// Number of vertices from which distances are measured: many on a small mesh, fewer where each takes long.
std::size_t base_count(std::size_t vertices) {
    constexpr std::size_t fewest = 12;
    constexpr std::size_t most = 60;
    constexpr std::size_t measured = 6'000'000;
    return std::clamp(measured / vertices, fewest, most);
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
    meter.enter("measuring distances", 0);
    const SurfaceGraph graph(mesh.triangles, mesh.positions);
    const std::vector<double> height = mean_distances(graph, vertex_areas(mesh.triangles, mesh.positions),
                                                      base_count(mesh.positions.size()), 0, 1, meter);
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
