// A grid over the roots in the plane that finds the roots over which a triangle lies.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "sequence/series/plane_mesh.h"

namespace interleaf {

class RootGrid {
  public:
    /// \param roots  counter-clockwise, with areas; must outlive the grid
    explicit RootGrid(std::span<const PlaneTriangle> roots);

    /// The roots whose interior meets that of \p triangle, in no particular but deterministic order.
    void overlapping(const PlaneTriangle& triangle, std::vector<Index>& found) const;

  private:
    struct Box {
        glm::dvec2 low;
        glm::dvec2 high;
    };
    /// Columns and rows from `low` to `high`, inclusive.
    struct Cells {
        std::array<std::size_t, 2> low;
        std::array<std::size_t, 2> high;
    };
    static Box box_of(const PlaneTriangle& triangle);
    Cells cells_of(const Box& box) const;

    std::span<const PlaneTriangle> roots_;
    std::vector<Box> boxes_;  ///< of the roots
    glm::dvec2 origin_;
    glm::dvec2 cells_per_length_;
    std::size_t cells_per_axis_;
    std::vector<Index> begins_;  ///< per cell, then the number of entries
    std::vector<Index> entries_;
};

}  // namespace interleaf
