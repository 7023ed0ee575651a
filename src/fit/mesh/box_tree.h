// A bounding volume tree: finds, among many boxes, those that contain a point, or the item nearest to a
// point.
//
// The tree halves the boxes at the median of their centers along the longest axis, down to a few boxes per
// node. Item numbers break ties, so the tree and the order of its walk depend on the boxes alone.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

struct SpaceBox {
    glm::dvec3 min;
    glm::dvec3 max;

    /// The square of the distance of \p point from the box; 0 inside.
    double squared_distance(const glm::dvec3& point) const {
        const glm::dvec3 outside = glm::max(glm::max(min - point, point - max), glm::dvec3(0));
        return glm::dot(outside, outside);
    }
    bool contains(const glm::dvec3& point) const {
        return point.x >= min.x && point.x <= max.x && point.y >= min.y && point.y <= max.y &&
               point.z >= min.z && point.z <= max.z;
    }
};

class BoxTree {
  public:
    /// \pre \p boxes is not empty, and all boxes are finite
    explicit BoxTree(std::span<const SpaceBox> boxes);

    /// Calls \p visit(Index item) for items near \p point, until \p visit returns true. The items include
    /// every item whose box contains \p point.
    /// \return whether \p visit returned true
    template <typename Visit>
    bool find(const glm::dvec3& point, Visit visit) const {
        std::array<Index, max_levels> open;
        std::size_t count = 0;
        open[count++] = 0;
        while (count > 0) {
            const Node& node = nodes_[open[--count]];
            if (!node.box.contains(point)) continue;
            if (node.item_count == 0) {
                open[count++] = node.first + 1;
                open[count++] = node.first;
                continue;
            }
            for (Index i = node.first; i < node.first + node.item_count; ++i)
                if (visit(items_[i])) return true;
        }
        return false;
    }

    /// Calls \p squared_distance(Index item), the square of the item's distance from \p point, for all items
    /// that may be nearer than the square root of \p least. Keeps the smallest square so far in \p least.
    /// Stops as soon as \p least is at most \p enough.
    /// \pre no item is nearer than its box
    template <typename SquaredDistance>
    void find_nearest(const glm::dvec3& point, double& least, double enough,
                      SquaredDistance squared_distance) const {
        std::array<std::pair<double, Index>, max_levels> open;
        std::size_t count = 0;
        open[count++] = {nodes_[0].box.squared_distance(point), 0};
        while (count > 0 && least > enough) {
            const auto [distance, number] = open[--count];
            if (distance >= least) continue;
            const Node& node = nodes_[number];
            for (Index i = node.first; i < node.first + node.item_count; ++i)
                if (item_boxes_[i].squared_distance(point) < least)
                    least = std::min(least, squared_distance(items_[i]));
            if (node.item_count > 0) continue;
            std::pair near = {nodes_[node.first].box.squared_distance(point), node.first};
            std::pair far = {nodes_[node.first + 1].box.squared_distance(point), node.first + 1};
            if (far.first < near.first) std::swap(near, far);
            if (far.first < least) open[count++] = far;
            if (near.first < least) open[count++] = near;
        }
    }

  private:
    /// Halving 2^32 items ends well before this many levels.
    static constexpr std::size_t max_levels = 48;

    struct Node {
        SpaceBox box;
        Index first;       ///< the first of two consecutive children, or of the items
        Index item_count;  ///< 0 if the node has children
    };

    void build(Index number, Index begin, Index end, std::span<const SpaceBox> boxes);

    std::vector<Node> nodes_;
    std::vector<Index> items_;
    std::vector<SpaceBox> item_boxes_;  ///< of items_
};

}  // namespace interleaf
