#include "io/crossing_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace interleaf {
namespace {

/// Steps of the grid that a crossing must be deep at least.
constexpr double least_depth = 1e-6 * static_cast<double>(plane_steps);

struct Edge {
    PlanePoint left;  ///< the lesser of its ends, by x and then y: so no edge counts as upright
    PlanePoint right;
    std::size_t corner;

    double length() const {
        return std::hypot(static_cast<double>(right.x - left.x), static_cast<double>(right.y - left.y));
    }
};

/// How far the nearer end of \p edge is from the line of \p other, if its ends are on both sides; or 0.
double depth_across(const Edge& edge, const Edge& other) {
    const std::int64_t left = orientation(other.left, other.right, edge.left);
    const std::int64_t right = orientation(other.left, other.right, edge.right);
    if ((left < 0) == (right < 0) || left == 0 || right == 0) return 0;
    return static_cast<double>(std::min(std::abs(left), std::abs(right))) / other.length();
}

bool do_cross(const Edge& a, const Edge& b) {
    return std::min(depth_across(a, b), depth_across(b, a)) > least_depth;
}

/// The order of edges from below upward along a line that both meet. Edges that touch are in the order that
/// they have beside the touch.
struct IsBelow {
    bool operator()(const Edge* a, const Edge* b) const {
        if (a->left < b->left) return side(*a, *b) > 0 || (side(*a, *b) == 0 && a->corner < b->corner);
        return side(*b, *a) < 0 || (side(*b, *a) == 0 && a->corner < b->corner);
    }

    /// Whether \p later, whose left end is not before that of \p edge, is above it (1), below (-1) or on it.
    static int side(const Edge& edge, const Edge& later) {
        for (const PlanePoint& end : {later.left, later.right}) {
            const std::int64_t turn = orientation(edge.left, edge.right, end);
            if (turn != 0) return turn > 0 ? 1 : -1;
        }
        return 0;
    }
};

/// Whether two edges go from one place to another.
bool has_repeated_edge(std::span<const PlanePoint> corners) {
    std::vector<std::pair<PlanePoint, PlanePoint>> edges;
    edges.reserve(corners.size());
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
        edges.emplace_back(corners[corner], corners[(corner + 1) % corners.size()]);
        if (edges.back().first == edges.back().second) edges.pop_back();
    }
    std::ranges::sort(edges);
    return std::ranges::adjacent_find(edges) != edges.end();
}

}  // namespace

bool has_crossing_edges(std::span<const PlanePoint> corners) {
    if (has_repeated_edge(corners)) return true;

    std::vector<Edge> edges;
    edges.reserve(corners.size());
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
        const PlanePoint& a = corners[corner];
        const PlanePoint& b = corners[(corner + 1) % corners.size()];
        if (a != b) edges.push_back({std::min(a, b), std::max(a, b), corner});
    }

    struct Event {
        PlanePoint at;
        bool begins;  ///< edges that end at a place go before others begin there
        std::size_t edge;
        auto operator<=>(const Event&) const = default;
    };
    std::vector<Event> events;
    events.reserve(2 * edges.size());
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
        events.push_back({edges[edge].left, true, edge});
        events.push_back({edges[edge].right, false, edge});
    }
    std::ranges::sort(events);

    using Sweep = std::multiset<const Edge*, IsBelow>;
    Sweep sweep;
    std::vector<Sweep::iterator> place(edges.size());
    for (const Event& event : events) {
        if (event.begins) {
            const Edge& edge = edges[event.edge];
            const auto here = sweep.insert(&edge);
            place[event.edge] = here;
            if (here != sweep.begin() && do_cross(**std::prev(here), edge)) return true;
            if (const auto above = std::next(here); above != sweep.end() && do_cross(**above, edge))
                return true;
        } else {
            const auto above = sweep.erase(place[event.edge]);
            if (above != sweep.begin() && above != sweep.end() && do_cross(**std::prev(above), **above))
                return true;
        }
    }
    return false;
}

}  // namespace interleaf
