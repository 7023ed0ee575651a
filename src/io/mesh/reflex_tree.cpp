#include "io/mesh/reflex_tree.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace interleaf {
namespace {

/// The largest number of corners in a leaf of the tree.
constexpr std::size_t leaf_size = 8;

/// How far a box reaches to the left of the line from \p a to \p b, as an area; negative if the whole box
/// lies to the right.
std::int64_t reach_left(const PlanePoint& least, const PlanePoint& most, const PlanePoint& a,
                        const PlanePoint& b) {
    const PlanePoint farthest_left{b.y > a.y ? least.x : most.x, b.x > a.x ? most.y : least.y};
    return orientation(a, b, farthest_left);
}

}  // namespace

ReflexTree::ReflexTree(std::span<const PlanePoint> points, std::vector<Index> corners)
    : points_(points), corners_(std::move(corners)), place_(points.size(), corners_.size()) {
    if (corners_.empty()) return;
    std::size_t depth_nodes = 1;
    for (std::size_t size = corners_.size(); size > leaf_size; size = (size + 1) / 2) depth_nodes *= 2;
    nodes_.resize(2 * depth_nodes);
    build({0, corners_.size(), 0});
    for (std::size_t i = 0; i < corners_.size(); ++i) place_[corners_[i]] = i;
}

void ReflexTree::build(Range range) {
    Node node{points_[corners_[range.begin]], points_[corners_[range.begin]], range.end - range.begin};
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const PlanePoint& point = points_[corners_[i]];
        node.least = {std::min(node.least.x, point.x), std::min(node.least.y, point.y)};
        node.most = {std::max(node.most.x, point.x), std::max(node.most.y, point.y)};
    }
    nodes_[range.node] = node;
    if (node.count <= leaf_size) return;
    const bool along_x = node.most.x - node.least.x >= node.most.y - node.least.y;
    const std::size_t middle = (range.begin + range.end) / 2;
    std::nth_element(corners_.begin() + static_cast<std::ptrdiff_t>(range.begin),
                     corners_.begin() + static_cast<std::ptrdiff_t>(middle),
                     corners_.begin() + static_cast<std::ptrdiff_t>(range.end), [&](Index a, Index b) {
                         return along_x ? points_[a].x < points_[b].x : points_[a].y < points_[b].y;
                     });
    build({range.begin, middle, 2 * range.node + 1});
    build({middle, range.end, 2 * range.node + 2});
}

void ReflexTree::remove(Index corner) {
    const std::size_t place = std::exchange(place_[corner], corners_.size());
    if (place == corners_.size()) return;
    Range range{0, corners_.size(), 0};
    while (true) {
        --nodes_[range.node].count;
        if (range.end - range.begin <= leaf_size) return;
        const std::size_t middle = (range.begin + range.end) / 2;
        range = place < middle ? Range{range.begin, middle, 2 * range.node + 1}
                               : Range{middle, range.end, 2 * range.node + 2};
    }
}

bool ReflexTree::has_inside(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c,
                            Border border) const {
    if (corners_.empty()) return false;
    // A point on a side, up to rounding, counts as inside or outside as border says.
    const auto min_reach = [&](const PlanePoint& from, const PlanePoint& to) {
        constexpr double max_rounding = 4;
        return border == Border::outside ? std::int64_t{1}
                                         : -static_cast<std::int64_t>(max_rounding * distance(from, to));
    };
    const std::int64_t beside_ab = min_reach(a, b);
    const std::int64_t beside_bc = min_reach(b, c);
    const std::int64_t beside_ca = min_reach(c, a);
    const auto is_corner = [&](const PlanePoint& point) { return point == a || point == b || point == c; };
    const auto is_inside = [&](Index corner) {
        if (place_[corner] == corners_.size()) return false;
        const PlanePoint& point = points_[corner];
        return orientation(a, b, point) >= beside_ab && orientation(b, c, point) >= beside_bc &&
               orientation(c, a, point) >= beside_ca && !is_corner(point);
    };
    const auto is_apart = [&](const Node& node) {
        // Thousands of corners may be at one place, so a box without extent is skipped as a whole.
        return node.count == 0 || (node.least == node.most && is_corner(node.least)) ||
               reach_left(node.least, node.most, a, b) < beside_ab ||
               reach_left(node.least, node.most, b, c) < beside_bc ||
               reach_left(node.least, node.most, c, a) < beside_ca ||
               std::min({a.x, b.x, c.x}) > node.most.x || std::max({a.x, b.x, c.x}) < node.least.x ||
               std::min({a.y, b.y, c.y}) > node.most.y || std::max({a.y, b.y, c.y}) < node.least.y;
    };
    // Each level halves the range, so at most one range per level waits.
    std::array<Range, 64> waiting;
    std::size_t count = 0;
    waiting[count++] = {0, corners_.size(), 0};
    while (count > 0) {
        const Range range = waiting[--count];
        if (is_apart(nodes_[range.node])) continue;
        if (range.end - range.begin <= leaf_size) {
            if (std::any_of(corners_.begin() + static_cast<std::ptrdiff_t>(range.begin),
                            corners_.begin() + static_cast<std::ptrdiff_t>(range.end), is_inside))
                return true;
            continue;
        }
        const std::size_t middle = (range.begin + range.end) / 2;
        waiting[count++] = {middle, range.end, 2 * range.node + 2};
        waiting[count++] = {range.begin, middle, 2 * range.node + 1};
    }
    return false;
}

}  // namespace interleaf
