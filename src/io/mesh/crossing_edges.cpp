#include "io/mesh/crossing_edges.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <vector>

namespace interleaf {
namespace {

/// One edge of the sweep.
struct SweptEdge {
    PlanePoint left;  ///< the lesser of its ends, by x and then y: so no edge counts as upright
    PlanePoint right;
    bool goes_right;
    std::size_t number;

    double length() const { return distance(left, right); }
};

/// How far the nearer end of \p edge is from the line of \p other, if its ends are on both sides; or 0.
double depth_across(const SweptEdge& edge, const SweptEdge& other) {
    const std::int64_t left = orientation(other.left, other.right, edge.left);
    const std::int64_t right = orientation(other.left, other.right, edge.right);
    if ((left < 0) == (right < 0) || left == 0 || right == 0) return 0;
    return static_cast<double>(std::min(std::abs(left), std::abs(right))) / other.length();
}

bool do_cross(const SweptEdge& a, const SweptEdge& b) {
    return std::min(depth_across(a, b), depth_across(b, a)) > min_depth;
}

/// Whether two edges go the same way along the same line, so that their areas overlap.
bool do_run_together(const SweptEdge& a, const SweptEdge& b) {
    if (a.goes_right != b.goes_right) return false;
    const PlanePoint begin = std::max(a.left, b.left);
    const PlanePoint end = std::min(a.right, b.right);
    return begin < end && distance(begin, end) > min_depth && orientation(a.left, a.right, b.left) == 0 &&
           orientation(a.left, a.right, b.right) == 0;
}

/// The order of edges from below upward along a line that both meet. Edges that touch are in the order that
/// they have beside the touch.
struct IsBelow {
    bool operator()(const SweptEdge* a, const SweptEdge* b) const {
        if (a->left < b->left) return side(*a, *b) > 0 || (side(*a, *b) == 0 && a->number < b->number);
        return side(*b, *a) < 0 || (side(*b, *a) == 0 && a->number < b->number);
    }

    /// Whether \p later, whose left end is not before that of \p edge, is above it (1), below (-1) or on it.
    static int side(const SweptEdge& edge, const SweptEdge& later) {
        for (const PlanePoint& end : {later.left, later.right}) {
            const std::int64_t turn = orientation(edge.left, edge.right, end);
            if (turn != 0) return turn > 0 ? 1 : -1;
        }
        return 0;
    }
};

}  // namespace

bool has_crossing(std::vector<PlaneEdge> edges, RunningTogether together) {
    std::erase_if(edges, [](const PlaneEdge& edge) { return edge.from == edge.to; });
    std::ranges::sort(edges);
    if (std::ranges::adjacent_find(edges) != edges.end()) return true;

    std::vector<SweptEdge> swept;
    swept.reserve(edges.size());
    for (const auto& [from, to] : edges)
        swept.push_back({std::min(from, to), std::max(from, to), from < to, swept.size()});
    const auto is_wrong = [together](const SweptEdge& a, const SweptEdge& b) {
        return do_cross(a, b) || (together == RunningTogether::forbidden && do_run_together(a, b));
    };

    struct Event {
        PlanePoint at;
        bool begins;  ///< edges that end at a place go before others begin there
        std::size_t edge;
        auto operator<=>(const Event&) const = default;
    };
    std::vector<Event> events;
    events.reserve(2 * swept.size());
    for (std::size_t edge = 0; edge < swept.size(); ++edge) {
        events.push_back({swept[edge].left, true, edge});
        events.push_back({swept[edge].right, false, edge});
    }
    std::ranges::sort(events);

    using Sweep = std::multiset<const SweptEdge*, IsBelow>;
    Sweep sweep;
    std::vector<Sweep::iterator> place(swept.size());
    for (const Event& event : events) {
        if (event.begins) {
            const SweptEdge& edge = swept[event.edge];
            const auto here = sweep.insert(&edge);
            place[event.edge] = here;
            if (here != sweep.begin() && is_wrong(**std::prev(here), edge)) return true;
            if (const auto above = std::next(here); above != sweep.end() && is_wrong(**above, edge))
                return true;
        } else {
            const auto above = sweep.erase(place[event.edge]);
            if (above != sweep.begin() && above != sweep.end() && is_wrong(**std::prev(above), **above))
                return true;
        }
    }
    return false;
}

}  // namespace interleaf
