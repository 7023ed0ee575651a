#include "fit/clean_up/surface_splitting.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>

#include "fit/mesh/half_edge_mesh.h"

namespace interleaf {
namespace {

/// Per corner 3 t + k, the number of its fan. Fans are numbered in the order of their first corners.
std::vector<Index> fans_of_corners(std::span<const Index> twin, ProgressMeter& meter) {
    std::vector<Index> fan(twin.size(), no_index);
    Index count = 0;
    for (Index first = 0; first < twin.size(); ++first) {
        if (fan[first] != no_index) continue;
        // Walks counter-clockwise to the boundary or around, then clockwise from the start.
        for (Index corner = first; corner != no_index && fan[corner] == no_index;
             corner = twin[HalfEdgeMesh::previous(corner)])
            fan[corner] = count;
        for (Index out = twin[first]; out != no_index && fan[HalfEdgeMesh::next(out)] == no_index;) {
            const Index corner = HalfEdgeMesh::next(out);
            fan[corner] = count;
            out = twin[corner];
        }
        ++count;
        meter.step();
    }
    return fan;
}

struct Edge {
    Index low;
    Index high;
    Index half_edge;
    auto ends() const { return std::tie(low, high); }
};

std::vector<Edge> sorted_edges(const SurfaceMesh& mesh, std::span<const Index> twin, ProgressMeter& meter) {
    std::vector<Edge> edges;
    for (Index half_edge = 0; half_edge < twin.size(); ++half_edge) {
        if (twin[half_edge] < half_edge) continue;  // once per edge; no_index is larger than any
        const Index from = mesh.triangles[half_edge / 3][half_edge % 3];
        const Index to = mesh.triangles[half_edge / 3][(half_edge % 3 + 1) % 3];
        edges.push_back({std::min(from, to), std::max(from, to), half_edge});
        meter.step();
    }
    std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) {
        meter.step(1);
        return std::tie(a.low, a.high, a.half_edge) < std::tie(b.low, b.high, b.half_edge);
    });
    return edges;
}

/// Puts a vertex on the edge of \p half_edge, and a new triangle on each side of the edge.
void bisect_edge(SurfaceMesh& mesh, std::vector<Index>& twin, Index half_edge) {
    const auto midpoint = static_cast<Index>(mesh.positions.size());
    const Index from = mesh.triangles[half_edge / 3][half_edge % 3];
    const Index to = mesh.triangles[half_edge / 3][(half_edge % 3 + 1) % 3];
    mesh.positions.push_back((mesh.positions[from] + mesh.positions[to]) * 0.5);
    if (!mesh.colors.empty()) mesh.colors.push_back((mesh.colors[from] + mesh.colors[to]) * 0.5F);
    append_mean(mesh.scalars, std::array{from, to}, std::array{0.5, 0.5});

    // Turns (from, to, x) into (from, midpoint, x), adds (midpoint, to, x), and returns the new triangle's
    // number.
    const auto divide = [&](Index edge) {
        const auto added = static_cast<Index>(mesh.triangles.size());
        Triangle& triangle = mesh.triangles[edge / 3];
        const Triangle rest = {midpoint, triangle[(edge % 3 + 1) % 3], triangle[(edge % 3 + 2) % 3]};
        triangle[(edge % 3 + 1) % 3] = midpoint;
        mesh.triangles.push_back(rest);
        const Index to_third = HalfEdgeMesh::next(edge);
        const Index beyond = twin[to_third];
        twin.insert(twin.end(), {no_index, beyond, to_third});
        if (beyond != no_index) twin[beyond] = 3 * added + 1;
        twin[to_third] = 3 * added + 2;
        return 3 * added;
    };
    const Index opposite = twin[half_edge];
    const Index first_added = divide(half_edge);
    if (opposite == no_index) return;
    const Index second_added = divide(opposite);
    twin[half_edge] = second_added;
    twin[second_added] = half_edge;
    twin[opposite] = first_added;
    twin[first_added] = opposite;
}

}  // namespace

std::vector<Index> split_vertices(SurfaceMesh& mesh, std::span<const Index> twin, ProgressMeter& meter) {
    const std::vector<Index> fan = fans_of_corners(twin, meter);
    std::vector<Index> old_vertex;  // per fan
    for (Index corner = 0; corner < fan.size(); ++corner)
        if (fan[corner] == old_vertex.size()) old_vertex.push_back(mesh.triangles[corner / 3][corner % 3]);

    std::vector<Index> order(old_vertex.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        meter.step(1);
        return std::tie(old_vertex[a], a) < std::tie(old_vertex[b], b);
    });
    std::vector<Index> number(order.size());
    SurfaceMesh split;
    split.scalars.reserve(mesh.scalars.size());
    for (const MeshField& scalar : mesh.scalars) split.scalars.push_back({scalar.name, 1, {}});
    std::vector<Index> source;
    for (const Index old_fan : order) {
        number[old_fan] = static_cast<Index>(source.size());
        const Index vertex = old_vertex[old_fan];
        source.push_back(vertex);
        split.positions.push_back(mesh.positions[vertex]);
        if (!mesh.colors.empty()) split.colors.push_back(mesh.colors[vertex]);
        for (std::size_t s = 0; s < split.scalars.size(); ++s)
            split.scalars[s].values.push_back(mesh.scalars[s].values[vertex]);
    }
    split.triangles = std::move(mesh.triangles);
    for (Index corner = 0; corner < fan.size(); ++corner)
        split.triangles[corner / 3][corner % 3] = number[fan[corner]];
    mesh = std::move(split);
    return source;
}

std::size_t split_double_edges(SurfaceMesh& mesh, std::vector<Index>& twin, ProgressMeter& meter) {
    // Bisecting an edge renames other edges of its triangles, so each round leaves these for the next round.
    std::size_t count = 0;
    for (std::size_t before = no_index; count != before;) {
        before = count;
        const std::vector<Edge> edges = sorted_edges(mesh, twin, meter);
        std::vector<char> is_renamed(mesh.triangles.size());
        for (std::size_t i = 1; i < edges.size(); ++i) {
            if (edges[i].ends() != edges[i - 1].ends()) continue;
            const Index half_edge = edges[i].half_edge;
            const Index opposite = twin[half_edge];
            if (is_renamed[half_edge / 3] || (opposite != no_index && is_renamed[opposite / 3])) continue;
            is_renamed[half_edge / 3] = 1;
            if (opposite != no_index) is_renamed[opposite / 3] = 1;
            bisect_edge(mesh, twin, half_edge);
            ++count;
        }
    }
    return count;
}

}  // namespace interleaf
