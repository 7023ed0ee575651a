#include "sequence/series/root_grid.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace interleaf {

RootGrid::Box RootGrid::box_of(const PlaneTriangle& triangle) {
    const auto& [a, b, c] = triangle.corners;
    return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

RootGrid::RootGrid(std::span<const PlaneTriangle> roots)
    : roots_(roots),
      cells_per_axis_(static_cast<std::size_t>(std::sqrt(static_cast<double>(roots.size()))) + 1) {
    Box whole = box_of(roots[0]);
    for (const PlaneTriangle& root : roots) {
        const Box& box = boxes_.emplace_back(box_of(root));
        whole = {glm::min(whole.low, box.low), glm::max(whole.high, box.high)};
    }
    origin_ = whole.low;
    cells_per_length_ = static_cast<double>(cells_per_axis_) / (whole.high - whole.low);

    // The entries of all cells are counted, then filled in.
    begins_.assign(cells_per_axis_ * cells_per_axis_ + 1, 0);
    const auto for_cells = [&](const auto& visit) {
        for (Index r = 0; r < roots.size(); ++r) {
            const Cells cells = cells_of(boxes_[r]);
            for (std::size_t row = cells.low[1]; row <= cells.high[1]; ++row)
                for (std::size_t column = cells.low[0]; column <= cells.high[0]; ++column)
                    visit(row * cells_per_axis_ + column, r);
        }
    };
    for_cells([&](std::size_t cell, Index) { ++begins_[cell + 1]; });
    for (std::size_t cell = 1; cell < begins_.size(); ++cell) begins_[cell] += begins_[cell - 1];
    entries_.resize(begins_.back());
    std::vector<Index> places(begins_.begin(), begins_.end() - 1);
    for_cells([&](std::size_t cell, Index r) { entries_[places[cell]++] = r; });
}

RootGrid::Cells RootGrid::cells_of(const Box& box) const {
    const double last = static_cast<double>(cells_per_axis_ - 1);
    Cells cells{};
    for (int axis = 0; axis < 2; ++axis) {
        const auto cell = [&](double at) {
            const double number = (at - origin_[axis]) * cells_per_length_[axis];
            return static_cast<std::size_t>(std::clamp(number, 0.0, last));
        };
        cells.low[static_cast<std::size_t>(axis)] = cell(box.low[axis]);
        cells.high[static_cast<std::size_t>(axis)] = cell(box.high[axis]);
    }
    return cells;
}

void RootGrid::overlapping(const PlaneTriangle& triangle, std::vector<Index>& found) const {
    found.clear();
    const Box box = box_of(triangle);
    const Cells cells = cells_of(box);
    for (std::size_t row = cells.low[1]; row <= cells.high[1]; ++row)
        for (std::size_t column = cells.low[0]; column <= cells.high[0]; ++column) {
            const std::size_t cell = row * cells_per_axis_ + column;
            for (Index entry = begins_[cell]; entry < begins_[cell + 1]; ++entry) {
                // A root in several cells is looked at in the first of them that the triangle meets.
                const Index r = entries_[entry];
                const Box& other = boxes_[r];
                const Cells own = cells_of(other);
                if (row != std::max(own.low[1], cells.low[1]) || column != std::max(own.low[0], cells.low[0]))
                    continue;
                const bool is_near = other.low.x <= box.high.x && box.low.x <= other.high.x &&
                                     other.low.y <= box.high.y && box.low.y <= other.high.y;
                if (is_near && triangle.overlaps(roots_[r])) found.push_back(r);
            }
        }
}

}  // namespace interleaf
