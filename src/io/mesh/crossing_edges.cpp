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
    PlanePoint left;  ///< the smaller end, by x and then by y, so that no edge counts as vertical
    PlanePoint right;
    bool goes_right;
    std::size_t number;

    double length() const { return distance(left, right); }
};

/// The distance of the nearer end of \p edge from the line of \p other; 0 if both ends are on one side of it.
double depth_across(const SweptEdge& edge, const SweptEdge& other) {
    const std::int64_t left = orientation(other.left, other.right, edge.left);
    const std::int64_t right = orientation(other.left, other.right, edge.right);
    if ((left < 0) == (right < 0) || left == 0 || right == 0) return 0;
    return static_cast<double>(std::min(std::abs(left), std::abs(right))) / other.length();
}

bool do_cross(const SweptEdge& a, const SweptEdge& b) {
    return std::min(depth_across(a, b), depth_across(b, a)) > min_depth;
}

/// Whether two edges overlap in the same direction along one line, so that their areas overlap.
bool do_run_together(const SweptEdge& a, const SweptEdge& b) {
    if (a.goes_right != b.goes_right) return false;
    const PlanePoint begin = std::max(a.left, b.left);
    const PlanePoint end = std::min(a.right, b.right);
    return begin < end && distance(begin, end) > min_depth && orientation(a.left, a.right, b.left) == 0 &&
           orientation(a.left, a.right, b.right) == 0;
}

/// The upward order of two edges along a vertical line that meets both. Edges that touch have the order that
/// they have beside the touch.
struct IsBelow {
    bool operator()(const SweptEdge* a, const SweptEdge* b) const {
        if (a->left < b->left) return side(*a, *b) > 0 || (side(*a, *b) == 0 && a->number < b->number);
        return side(*b, *a) < 0 || (side(*b, *a) == 0 && a->number < b->number);
    }

    /// Whether \p later is above \p edge (1), below it (-1) or on it (0).
    /// \pre the left end of \p later is not before the left end of \p edge
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
        bool begins;  ///< edges that end at a place are removed before other edges begin there
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
