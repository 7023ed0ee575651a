// The root complex: the coarse triangulation that all keys of a family share (paper, section 3.2, constraints
// (B)).
//
// It is an orientable triangulated 2-manifold, closed or with boundary, of any genus and with any number of
// components. It is also a simplicial complex: no two triangles have the same three vertices. The order of
// each triple carries the marking: the refinement edge is opposite the first vertex. The complex holds
// connectivity only; positions belong to the keys. It never changes, so copies share one memory.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hierarchy/error.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// The triangles are no root complex.
struct RootError : InputError {
    RootError(const std::string& text, std::size_t at) : InputError(text), triangle(at) {}
    std::size_t triangle;  ///< a triangle that shows the fault
};

class RootComplex {
  public:
    RootComplex();
    ~RootComplex() = default;
    // no move: a copy costs as little, and leaves no empty shell behind
    RootComplex(const RootComplex&) = default;
    RootComplex& operator=(const RootComplex&) = default;

    /// \param vertex_count  number of vertices; each must be used by a triangle
    /// \param triangles     vertex triples, consistently oriented, first vertex opposite the refinement edge
    /// \throw InputError  naming the triangle, edge or vertex, unless the triangles are such a manifold; a
    ///     RootError if a triangle is at fault
    RootComplex(Index vertex_count, std::vector<Triangle> triangles);

    std::span<const Triangle> triangles() const { return connectivity_->triangles; }

    /// The neighbors of each triangle, across the edges opposite its three vertices; no_index at the
    /// boundary.
    std::span<const Triangle> neighbors() const { return connectivity_->neighbors; }

    Index triangle_count() const { return static_cast<Index>(triangles().size()); }
    Index vertex_count() const { return connectivity_->vertex_count; }
    Index boundary_edge_count() const { return connectivity_->boundary_edge_count; }

    /// Vertices - edges + faces: 2 - 2 genus for a closed connected surface. Bisection does not change it.
    int euler_number() const;

    /// Whether both have the same vertices, and the same triples in the same order. Keys over equal complexes
    /// satisfy constraints (B).
    bool operator==(const RootComplex& other) const;

  private:
    struct Connectivity {
        Index vertex_count = 0;
        Index boundary_edge_count = 0;
        std::vector<Triangle> triangles;
        std::vector<Triangle> neighbors;
    };
    std::shared_ptr<const Connectivity> connectivity_;
};

}  // namespace interleaf
