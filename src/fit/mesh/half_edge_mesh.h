// A closed triangle mesh as half-edges, with edge collapses that can be undone in reverse order, edge flips
// and edge splits.
//
// Half-edge 3 t + k runs from corner k of triangle t to the next corner. It is not side k of t, which is
// opposite corner k (hierarchy/triangle.h); on_side() converts. A half-edge collapse (v to w) removes v and
// two triangles. The data of the removed triangles stay in place, so undoing a collapse needs only the
// collapsed half-edge (the links "dance" back, Knuth 2000). The mesh must be a simplicial complex and stay
// one: see decimation.h.
#pragma once

#include <span>
#include <vector>

#include "hierarchy/triangle.h"

namespace interleaf {

class HalfEdgeMesh {
  public:
    /// \param triangles  a closed, oriented manifold that uses each of \p vertex_count vertices and joins no
    ///                   two of them twice
    /// \throw InputError naming the edge or vertex that breaks this rule
    HalfEdgeMesh(Index vertex_count, std::span<const Triangle> triangles);

    static Index next(Index half_edge) { return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1; }
    static Index previous(Index half_edge) { return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1; }

    /// The half-edge on side k of triangle t, opposite corner k.
    static Index on_side(Index triangle, Index k) { return next(3 * triangle + k); }

    Index vertex_capacity() const { return static_cast<Index>(outgoing_.size()); }
    Index triangle_capacity() const { return static_cast<Index>(origin_.size() / 3); }

    bool has_vertex(Index vertex) const { return outgoing_[vertex] != no_index; }
    bool has_triangle(Index triangle) const { return has_triangle_[triangle]; }

    /// Whether the surface is in one piece.
    /// \pre nothing is collapsed
    bool is_connected() const;

    Index origin(Index half_edge) const { return origin_[half_edge]; }
    Index target(Index half_edge) const { return origin_[next(half_edge)]; }
    Index twin(Index half_edge) const { return twin_[half_edge]; }

    /// Number of edges at \p vertex.
    Index degree(Index vertex) const { return degree_[vertex]; }

    /// A half-edge from \p vertex.
    Index outgoing(Index vertex) const { return outgoing_[vertex]; }

    /// The next half-edge counter-clockwise from the same vertex.
    Index rotated(Index half_edge) const { return twin_[previous(half_edge)]; }

    /// Calls \p visit with each half-edge from \p vertex, counter-clockwise.
    template <typename Visit>
    void for_spokes(Index vertex, Visit visit) const {
        const Index begin = outgoing(vertex);
        Index spoke = begin;
        do {
            visit(spoke);
            spoke = rotated(spoke);
        } while (spoke != begin);
    }

    /// Moves the origin v of \p half_edge onto its target w. This removes v and the two triangles at the
    /// edge.
    /// \pre v and w have exactly two common neighbors, and there are more than four vertices.
    void collapse(Index half_edge);

    /// Undoes the collapse of \p half_edge, which must be the last collapse that has not been undone.
    void undo_collapse(Index half_edge);

    /// Whether an edge joins the two vertices. Takes time proportional to the smaller degree.
    bool are_joined(Index a, Index b) const;

    /// Turns the edge a b of \p half_edge, between the triangles a b c and b a d, into the edge d c.
    /// \p half_edge then runs from d to c, and its twin from c to d.
    /// \pre c and d are not joined. No earlier collapse may be undone afterwards.
    void flip(Index half_edge);

    /// Puts a new vertex, with the next number, on the edge a b of \p half_edge, and halves both triangles at
    /// the edge. \p half_edge then runs from a to the new vertex.
    /// \return the new vertex
    Index split(Index half_edge);

  private:
    void check_fan(Index vertex) const;
    void join(Index half_edge, Index twin) {
        twin_[half_edge] = twin;
        twin_[twin] = half_edge;
    }

    std::vector<Index> origin_;
    std::vector<Index> twin_;
    std::vector<Index> outgoing_;
    std::vector<Index> degree_;
    std::vector<char> has_triangle_;
};

}  // namespace interleaf
