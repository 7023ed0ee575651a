#include "fit/mesh/box_tree.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace interleaf {
namespace {

constexpr Index max_items = 4;

}  // namespace

BoxTree::BoxTree(std::span<const SpaceBox> boxes) : items_(boxes.size()) {
    assert(!boxes.empty());
    std::iota(items_.begin(), items_.end(), Index{0});
    nodes_.reserve(boxes.size());
    nodes_.emplace_back();
    build(0, 0, static_cast<Index>(boxes.size()), boxes);
    item_boxes_.reserve(boxes.size());
    for (const Index item : items_) item_boxes_.push_back(boxes[item]);
}

void BoxTree::build(Index number, Index begin, Index end, std::span<const SpaceBox> boxes) {
    const auto doubled_center = [&](Index item) { return boxes[item].min + boxes[item].max; };
    SpaceBox box = boxes[items_[begin]];
    SpaceBox centers{doubled_center(items_[begin]), doubled_center(items_[begin])};
    for (Index i = begin + 1; i < end; ++i) {
        const Index item = items_[i];
        box = {glm::min(box.min, boxes[item].min), glm::max(box.max, boxes[item].max)};
        centers = {glm::min(centers.min, doubled_center(item)), glm::max(centers.max, doubled_center(item))};
    }
    nodes_[number] = {box, begin, end - begin};
    if (end - begin <= max_items) return;

    const glm::dvec3 sides = centers.max - centers.min;
    const int axis = sides.x >= sides.y && sides.x >= sides.z ? 0 : (sides.y >= sides.z ? 1 : 2);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [&](Index a, Index b) {
                         const double at_a = doubled_center(a)[axis];
                         const double at_b = doubled_center(b)[axis];
                         return at_a != at_b ? at_a < at_b : a < b;
                     });
    const auto first = static_cast<Index>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[number] = {box, first, 0};
    build(first, begin, middle, boxes);
    build(first + 1, middle, end, boxes);
}

}  // namespace interleaf
