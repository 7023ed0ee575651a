// A flat mesh as the leaves of trees: finds the leaves below a triangle from the places of the vertices. A
// triangle is a leaf, or the vertex at the middle of its refinement edge bisects it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "sequence/series/point_index.h"
#include "sequence/series/triangle_index.h"

namespace interleaf {

/// The leaves below a triangle.
struct Expansion {
    std::vector<Leaf> leaves;      ///< in preorder, with the vertices of the mesh; levels below the triangle
    std::vector<Index> triangles;  ///< the number in the mesh of each leaf

    void clear() {
        leaves.clear();
        triangles.clear();
    }
};

class PlaceLookup {
  public:
    /// \param points     the vertices, among others; must outlive the lookup
    /// \param triangles  the leaves; must outlive the lookup
    /// \param is_marked  per triangle: whether its refinement edge is known, opposite its first vertex; empty if
    ///     none is known. Must outlive the lookup
    /// \param tolerance  vertices within this distance are at one place
    PlaceLookup(std::span<const glm::dvec3> points, std::span<const Triangle> triangles,
                const std::vector<bool>& is_marked, double tolerance);

    /// The vertex at \p at; no_index if there is none.
    Index vertex_at(const glm::dvec3& at) const { return point_index_.find(at); }

    /// Finds the leaves below \p root, whose refinement edge is opposite its first vertex.
    /// \return whether leaves fill the triangle; if so, \p found is these leaves
    bool expand(const Triangle& root, Expansion& found) const;

    /// Finds the leaves below \p root, whose refinement edge may be any. At most one edge fits
    /// (docs/series.md).
    /// \return the corner opposite the refinement edge, 0 if the triangle is a leaf; none if leaves do not fill
    ///     the triangle
    std::optional<unsigned> expand_any(const Triangle& root, Expansion& found) const;

  private:
    Index leaf_at(const Leaf& node) const;
    Index midpoint_of(const Triangle& node) const;

    std::span<const glm::dvec3> points_;
    std::span<const Triangle> triangles_;
    const std::vector<bool>& is_marked_;
    PointIndex point_index_;
    TriangleIndex triangle_index_;
};

}  // namespace interleaf
