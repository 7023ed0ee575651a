// The root complex: the coarse triangulation that all keys of a family share (paper, section 3.2, constraints
// (B)).
//
// It is an orientable triangulated 2-manifold, closed or with boundary, of any genus and any number of
// components, and a simplicial complex: no two triangles have the same three vertices. The order of each
// triple carries the marking: the refinement edge is opposite the first vertex. Connectivity only; positions
// belong to the keys.
#pragma once

#include <span>
#include <vector>

#include "hierarchy/triangle.h"

namespace interleaf {

class RootComplex {
  public:
    RootComplex() = default;

    /// \param vertex_count  number of vertices; each must be used by a triangle
    /// \param triangles     vertex triples, consistently oriented, first vertex opposite the refinement edge
    /// \throw InputError    naming the triangle, edge or vertex, unless this is such a manifold
    RootComplex(Index vertex_count, std::vector<Triangle> triangles);

    std::span<const Triangle> triangles() const { return triangles_; }

    /// For each triangle, its neighbours across the edges opposite its three vertices; no_index at the
    /// boundary.
    std::span<const Triangle> neighbours() const { return neighbours_; }

    Index triangle_count() const { return static_cast<Index>(triangles_.size()); }
    Index vertex_count() const { return vertex_count_; }
    Index boundary_edge_count() const { return boundary_edge_count_; }

    /// Vertices - edges + faces: 2 - 2 genus for a closed connected surface. Bisection keeps it.
    int euler_number() const;

    /// The same vertices and the same triples in the same order: such hierarchies fulfil constraints (B).
    bool operator==(const RootComplex& other) const {
        return vertex_count_ == other.vertex_count_ && triangles_ == other.triangles_;
    }

  private:
    Index vertex_count_ = 0;
    Index boundary_edge_count_ = 0;
    std::vector<Triangle> triangles_;
    std::vector<Triangle> neighbours_;
};

}  // namespace interleaf
