#include "sequence/series/place_lookup.h"

#include <algorithm>

namespace interleaf {

PlaceLookup::PlaceLookup(std::span<const glm::dvec3> points, std::span<const Triangle> triangles,
                         const std::vector<bool>& is_marked, double tolerance)
    : points_(points),
      triangles_(triangles),
      is_marked_(is_marked),
      point_index_(points, tolerance),
      triangle_index_(triangles) {
    std::vector<bool> is_added(points.size(), false);
    for (Index t = 0; t < triangles.size(); ++t) {
        triangle_index_.add(t);
        for (const Index vertex : triangles[t]) {
            if (is_added[vertex]) continue;
            is_added[vertex] = true;
            point_index_.add(vertex);
        }
    }
}

/// The triangle that \p node is; no_index if it is none, or one with another refinement edge.
Index PlaceLookup::leaf_at(const Leaf& node) const {
    const Index triangle = triangle_index_.find(node.vertices);
    const bool other_edge = triangle != no_index && node.level > 0 && !is_marked_.empty() &&
                            is_marked_[triangle] && triangles_[triangle][0] != node.vertices[0];
    return other_edge ? no_index : triangle;
}

/// The vertex that bisects \p node; no_index if there is none.
Index PlaceLookup::midpoint_of(const Triangle& node) const {
    const Index midpoint = vertex_at((points_[node[1]] + points_[node[2]]) / 2.0);
    return std::ranges::count(node, midpoint) > 0 ? no_index : midpoint;
}

bool PlaceLookup::expand(const Triangle& root, Expansion& found) const {
    found.clear();
    std::vector<Leaf> open = {{root, 0}};
    while (!open.empty()) {
        const Leaf node = open.back();
        open.pop_back();
        if (const Index triangle = leaf_at(node); triangle != no_index) {
            found.leaves.push_back(node);
            found.triangles.push_back(triangle);
            continue;
        }
        const Index midpoint = node.level < max_level ? midpoint_of(node.vertices) : no_index;
        if (midpoint == no_index) return false;
        const auto [first, second] = bisect(node.vertices, midpoint);
        const auto level = static_cast<std::uint8_t>(node.level + 1);
        open.push_back({second, level});
        open.push_back({first, level});
    }
    return true;
}

std::optional<unsigned> PlaceLookup::expand_any(const Triangle& root, Expansion& found) const {
    for (unsigned front = 0; front < 3; ++front)
        if (expand({root[front], root[(front + 1) % 3], root[(front + 2) % 3]}, found)) return front;
    return std::nullopt;
}

}  // namespace interleaf
