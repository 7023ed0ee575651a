// Finds triangles by their three vertices, in whatever order: a hash table.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hierarchy/triangle.h"

namespace interleaf {

class TriangleIndex {
  public:
    /// An empty index.
    /// \param triangles  must outlive the index
    explicit TriangleIndex(std::span<const Triangle> triangles);

    /// Adds the triangle with the number \p triangle.
    void add(Index triangle);

    /// The number of the triangle with the vertices of \p corners; no_index if there is none.
    Index find(const Triangle& corners) const;

  private:
    std::span<const Triangle> triangles_;
    std::size_t mask_;
    std::vector<Index> table_;  ///< open addressing; its size is a power of two, at least twice the triangles
};

}  // namespace interleaf
