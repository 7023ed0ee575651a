#include "sequence/series/triangle_index.h"

#include <algorithm>
#include <bit>

namespace interleaf {

namespace {

Triangle ascending(Triangle corners) {
    std::ranges::sort(corners);
    return corners;
}

std::uint64_t hash_of_corners(const Triangle& corners) {
    std::uint64_t mixed = 0;
    for (const Index corner : corners) {
        mixed = (mixed ^ corner) * 0x9e3779b97f4a7c15;
        mixed ^= mixed >> 29;
    }
    return mixed;
}

}  // namespace

TriangleIndex::TriangleIndex(std::span<const Triangle> triangles)
    : triangles_(triangles),
      mask_(std::bit_ceil(2 * triangles.size() + 1) - 1),
      table_(mask_ + 1, no_index) {}

void TriangleIndex::add(Index triangle) {
    std::size_t place = hash_of_corners(ascending(triangles_[triangle])) & mask_;
    while (table_[place] != no_index) place = (place + 1) & mask_;
    table_[place] = triangle;
}

Index TriangleIndex::find(const Triangle& corners) const {
    const Triangle wanted = ascending(corners);
    for (std::size_t place = hash_of_corners(wanted) & mask_; table_[place] != no_index;
         place = (place + 1) & mask_)
        if (ascending(triangles_[table_[place]]) == wanted) return table_[place];
    return no_index;
}

}  // namespace interleaf
