#include "sequence/series/point_index.h"

#include <algorithm>
#include <bit>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace interleaf {

namespace {

/// Moves the grid, because many points have coordinates such as 0 or 0.5, which would be borders of cells.
constexpr double grid_shift = 0.37;

/// Cells are this many tolerances wide, so that few queries are near a border.
constexpr double cell_width = 8;

/// The widest grid has this many cells per axis on each side of the origin, so that numbers of cells are exact.
constexpr double max_cells = 1e12;

}  // namespace

PointIndex::PointIndex(std::span<const glm::dvec3> points, double tolerance)
    : points_(points), tolerance_(tolerance), mask_(std::bit_ceil(2 * points.size() + 1) - 1) {
    double extent = 0;
    for (const glm::dvec3& point : points) {
        const glm::dvec3 size = glm::abs(point);
        extent = std::max({extent, size.x, size.y, size.z});
    }
    const double width = std::max({cell_width * tolerance, extent / max_cells, 1e-300});
    cells_per_length_ = 1 / width;
    table_.assign(mask_ + 1, no_index);
}

PointIndex::Cell PointIndex::cell_of(const glm::dvec3& at) const {
    return glm::floor(at * cells_per_length_ + grid_shift);
}

std::uint64_t PointIndex::hash(const Cell& cell) {
    std::uint64_t mixed = 0;
    for (int axis = 0; axis < 3; ++axis) {
        mixed ^= static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[axis]));
        mixed *= 0x9e3779b97f4a7c15;
        mixed ^= mixed >> 29;
    }
    return mixed;
}

Index PointIndex::find_in(const Cell& cell, const glm::dvec3& at) const {
    for (std::size_t place = hash(cell) & mask_; table_[place] != no_index; place = (place + 1) & mask_) {
        const glm::dvec3 apart = points_[table_[place]] - at;
        if (glm::dot(apart, apart) <= tolerance_ * tolerance_) return table_[place];
    }
    return no_index;
}

Index PointIndex::find(const glm::dvec3& at) const {
    // A far query has no number of a cell, and no point.
    const glm::dvec3 size = glm::abs(at) * cells_per_length_;
    if (!(std::max({size.x, size.y, size.z}) < 2 * max_cells)) return no_index;
    const Cell low = cell_of(at - tolerance_);
    const Cell high = cell_of(at + tolerance_);
    for (double x = low.x; x <= high.x; ++x)
        for (double y = low.y; y <= high.y; ++y)
            for (double z = low.z; z <= high.z; ++z)
                if (const Index found = find_in({x, y, z}, at); found != no_index) return found;
    return no_index;
}

void PointIndex::add(Index point) {
    std::size_t place = hash(cell_of(points_[point])) & mask_;
    while (table_[place] != no_index) place = (place + 1) & mask_;
    table_[place] = point;
}

}  // namespace interleaf
