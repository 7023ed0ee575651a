#include "hierarchy/marking.h"

#include <algorithm>
#include <cassert>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <glm/geometric.hpp>

namespace interleaf {

namespace {

/// The same triangle with its vertices rotated so that \p corner comes first.
Triangle rotated(const Triangle& triangle, unsigned corner) {
    return {triangle[corner], triangle[(corner + 1) % 3], triangle[(corner + 2) % 3]};
}

}  // namespace

RootComplex mark_longest_edges(const RootComplex& roots, std::span<const glm::vec3> positions) {
    std::vector<Triangle> triangles(roots.triangles().begin(), roots.triangles().end());
    for (Triangle& triangle : triangles) {
        const auto length = [&](unsigned corner) {
            return glm::distance(positions[triangle[(corner + 1) % 3]],
                                 positions[triangle[(corner + 2) % 3]]);
        };
        unsigned longest = 0;
        for (const unsigned corner : {1U, 2U})
            if (length(corner) > length(longest)) longest = corner;
        triangle = rotated(triangle, longest);
    }
    return {roots.vertex_count(), std::move(triangles)};
}

RootComplex mark_compatibly(const RootComplex& roots) {
    // Triangle t has the number t in the surface, and t + count in the mirror image that is glued on at the
    // boundary.
    const Index count = roots.triangle_count();
    const bool open = roots.boundary_edge_count() > 0;
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
    Graph dual(open ? 2 * count : count);
    for (Index t = 0; t < count; ++t)
        for (const Index neighbor : roots.neighbors()[t]) {
            if (neighbor == no_index) {
                boost::add_edge(t, t + count, dual);
            } else if (t < neighbor) {
                boost::add_edge(t, neighbor, dual);
                if (open) boost::add_edge(t + count, neighbor + count, dual);
            }
        }
    std::vector<Graph::vertex_descriptor> mate(boost::num_vertices(dual));
    boost::edmonds_maximum_cardinality_matching(dual, mate.data());

    std::vector<Triangle> triangles(roots.triangles().begin(), roots.triangles().end());
    for (Index t = 0; t < count; ++t) {
        assert(mate[t] != Graph::null_vertex());  // Petersen: the dual graph is cubic and has no bridge
        const Index partner = mate[t] == t + count ? no_index : static_cast<Index>(mate[t]);
        const Triangle& sides = roots.neighbors()[t];
        triangles[t] =
            rotated(triangles[t],
                    static_cast<unsigned>(std::find(sides.begin(), sides.end(), partner) - sides.begin()));
    }
    return {roots.vertex_count(), std::move(triangles)};
}

bool is_compatibly_marked(const RootComplex& roots) {
    for (Index t = 0; t < roots.triangle_count(); ++t) {
        const Index neighbor = roots.neighbors()[t][0];
        if (neighbor != no_index && roots.neighbors()[neighbor][0] != t) return false;
    }
    return true;
}

}  // namespace interleaf
