#include "hierarchy/matching/point_tree.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <utility>

namespace interleaf {

namespace {

constexpr int max_looks = 200;

}  // namespace

PointTree::PointTree(std::span<const glm::dvec3> points)
    : points_(points),
      order_(points.size()),
      left_(points.size()),
      axis_(points.size()),
      is_taken_(points.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    build(0, points.size());
}

void PointTree::build(std::size_t begin, std::size_t end) {
    if (begin == end) return;
    const std::size_t node = middle(begin, end);
    const int axis = longest_axis(begin, end);
    const auto place = [this](std::size_t n) { return order_.begin() + static_cast<std::ptrdiff_t>(n); };
    std::nth_element(place(begin), place(node), place(end), [&](std::size_t a, std::size_t b) {
        return std::pair(points_[a][axis], a) < std::pair(points_[b][axis], b);
    });
    left_[node] = end - begin;
    axis_[node] = static_cast<std::uint8_t>(axis);
    build(begin, node);
    build(node + 1, end);
}

int PointTree::longest_axis(std::size_t begin, std::size_t end) const {
    glm::dvec3 least = points_[order_[begin]], greatest = least;
    for (std::size_t place = begin; place < end; ++place)
        for (int axis = 0; axis < 3; ++axis) {
            const double at = points_[order_[place]][axis];
            least[axis] = std::min(least[axis], at);
            greatest[axis] = std::max(greatest[axis], at);
        }
    const glm::dvec3 extent = greatest - least;
    if (extent.x >= extent.y) return extent.x >= extent.z ? 0 : 2;
    return extent.y >= extent.z ? 1 : 2;
}

void PointTree::search(std::size_t begin, std::size_t end, Query& query) const {
    if (begin == end) return;
    const std::size_t node = middle(begin, end);
    if (left_[node] == 0 || (query.looks <= 0 && query.nearest)) return;
    --query.looks;
    const glm::dvec3 way = points_[order_[node]] - query.at;
    const double distance = way.x * way.x + way.y * way.y + way.z * way.z;
    if (!is_taken_[node] && distance < query.least) {
        query.least = distance;
        query.nearest = node;
    }
    const double beyond = way[axis_[node]];  // positive where the query lies before the node
    const auto search_before = [&] { search(begin, node, query); };
    const auto search_behind = [&] { search(node + 1, end, query); };
    beyond > 0 ? search_before() : search_behind();
    if (beyond * beyond < query.least) beyond > 0 ? search_behind() : search_before();
}

std::size_t PointTree::take_nearest(const glm::dvec3& at) {
    Query query{at, std::numeric_limits<double>::infinity(), std::nullopt, max_looks};
    search(0, order_.size(), query);
    assert(query.nearest);
    const std::size_t taken = *query.nearest;
    is_taken_[taken] = true;
    for (std::size_t begin = 0, end = order_.size(), node = end; node != taken;) {
        node = middle(begin, end);
        --left_[node];
        (taken < node ? end : begin) = taken < node ? node : node + 1;
    }
    return order_[taken];
}

}  // namespace interleaf
