#include "fit/mesh/mean_distances.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

namespace interleaf {
namespace {

/// The work of the progress meter per vertex that a distance reaches.
constexpr std::size_t work_per_vertex = 4;

Index largest_of(std::span<const double> values) {
    return static_cast<Index>(std::ranges::max_element(values) - values.begin());
}

}  // namespace

std::vector<double> vertex_areas(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions) {
    std::vector<double> areas(positions.size(), 0.0);
    for (const auto& [a, b, c] : triangles) {
        const double third =
            glm::length(glm::cross(positions[b] - positions[a], positions[c] - positions[a])) / 6;
        for (const Index vertex : {a, b, c}) areas[vertex] += third;
    }
    return areas;
}

std::vector<double> mean_distances(const SurfaceGraph& graph, std::span<const double> areas,
                                   std::size_t bases, double begin, double end, ProgressMeter& meter) {
    const std::size_t count = graph.vertex_count();
    bases = std::min(bases, count);
    std::vector<std::vector<float>> distances;
    std::vector<double> nearest(count, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> nearest_base(count);
    for (Index next = largest_of(graph.distances_from(0)); distances.size() < bases;
         next = largest_of(nearest)) {
        meter.set_part(begin + (end - begin) * double(distances.size()) / double(bases));
        const std::vector<double> from_base = graph.distances_from(next);
        meter.step(work_per_vertex * count);
        for (std::size_t v = 0; v < count; ++v) {
            if (from_base[v] >= nearest[v]) continue;
            nearest[v] = from_base[v];
            nearest_base[v] = distances.size();
        }
        distances.emplace_back(from_base.begin(), from_base.end());
    }
    std::vector<double> weight(bases);
    for (std::size_t v = 0; v < count; ++v) weight[nearest_base[v]] += areas[v];
    const double whole = std::accumulate(weight.begin(), weight.end(), 0.0);
    std::vector<double> mean(count);
    for (std::size_t base = 0; base < bases; ++base)
        for (std::size_t v = 0; v < count; ++v) mean[v] += weight[base] / whole * double(distances[base][v]);
    return mean;
}

}  // namespace interleaf
