#include "red_complex.h"

#include <algorithm>
#include <map>
#include <utility>

namespace interleaf::bench {

RedComplex::RedComplex(const RootComplex& roots, std::vector<glm::dvec3> points, MiddlePoint middle)
    : root_count_(roots.triangle_count()),
      root_vertex_count_(roots.vertex_count()),
      middle_(middle),
      points_(std::move(points)) {
    std::map<std::pair<Index, Index>, Index> edge_of;
    for (const Triangle& root : roots.triangles()) {
        RedNode node{root, {}};
        for (unsigned corner = 0; corner < 3; ++corner) {
            const std::pair<Index, Index> ends =
                std::minmax({root[(corner + 1) % 3], root[(corner + 2) % 3]});
            const auto [place, is_new] = edge_of.try_emplace(ends, static_cast<Index>(edges_.size()));
            if (is_new) add_edge(ends.first, ends.second);
            node.edges[corner] = place->second;
        }
        nodes_.push_back(node);
    }
}

Index RedComplex::add_edge(Index a, Index b) {
    edges_.push_back({{a, b}});
    return static_cast<Index>(edges_.size() - 1);
}

Index RedComplex::midpoint(Index edge) {
    if (edges_[edge].midpoint == no_index) {
        const auto [a, b] = edges_[edge].ends;
        const auto middle = static_cast<Index>(points_.size());
        points_.push_back(middle_(points_[a], points_[b]));
        const std::array<Index, 2> halves = {add_edge(a, middle), add_edge(middle, b)};
        edges_[edge].midpoint = middle;
        edges_[edge].halves = halves;
    }
    return edges_[edge].midpoint;
}

Index RedComplex::half_at(Index edge, Index end) const {
    return edges_[edge].halves[edges_[edge].ends[0] == end ? 0 : 1];
}

Index RedComplex::children(Index node) {
    if (nodes_[node].first_child != no_index) return nodes_[node].first_child;
    const RedNode parent = nodes_[node];
    Triangle middles{};
    for (unsigned c = 0; c < 3; ++c) middles[c] = midpoint(parent.edges[c]);
    std::array<Index, 3> inner{};
    for (unsigned c = 0; c < 3; ++c) inner[c] = add_edge(middles[(c + 1) % 3], middles[(c + 2) % 3]);

    const auto first = static_cast<Index>(nodes_.size());
    for (unsigned c = 0; c < 3; ++c) {
        const unsigned a = (c + 1) % 3;
        const unsigned b = (c + 2) % 3;
        RedNode child;
        child.vertices[c] = parent.vertices[c];
        child.vertices[a] = middles[b];
        child.vertices[b] = middles[a];
        child.edges[c] = inner[c];
        child.edges[a] = half_at(parent.edges[a], parent.vertices[c]);
        child.edges[b] = half_at(parent.edges[b], parent.vertices[c]);
        nodes_.push_back(child);
    }
    nodes_.push_back({middles, inner});
    nodes_[node].first_child = first;
    return first;
}

}  // namespace interleaf::bench
