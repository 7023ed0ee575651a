// Finds points by their place: a hash table over the cells of a grid. All points are about as far apart as the
// tolerance, or much farther, so a cell holds few of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "hierarchy/buffer.h"
#include "hierarchy/triangle.h"

namespace interleaf {

class PointIndex {
  public:
    /// An empty index.
    /// \param points     finite; must outlive the index
    /// \param tolerance  points within this distance are at one place; 0 for equal coordinates
    PointIndex(std::span<const glm::dvec3> points, double tolerance);

    /// The point at the place \p at: the one that was added first within the tolerance of a query; no_index if
    /// there is none.
    Index find(const glm::dvec3& at) const;

    /// Adds the point with the number \p point.
    void add(Index point);

  private:
    using Cell = glm::dvec3;  // whole numbers
    Cell cell_of(const glm::dvec3& at) const;
    static std::uint64_t hash(const Cell& cell);
    Index find_in(const Cell& cell, const glm::dvec3& at) const;

    std::span<const glm::dvec3> points_;
    double tolerance_;
    double cells_per_length_;
    std::size_t mask_;
    Buffer<Index> table_;  ///< open addressing; its size is a power of two, at least twice the points
};

}  // namespace interleaf
