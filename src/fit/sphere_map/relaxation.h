// Relaxes a map of a mesh to the sphere: moves one vertex after the other to the place where its star is
// distorted least.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"
#include "fit/sphere_map/spherical_star.h"

namespace interleaf {

class Relaxation {
  public:
    /// \param mesh         may be collapsed and restored between calls, if update_shapes() follows
    /// \param positions    on the surface, one per vertex
    /// \param vertex_area  per vertex, the part of 4 pi that the surface around the vertex is to take
    /// \param points       on the unit sphere, one per vertex; the points of the mesh's vertices are moved
    Relaxation(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
               std::span<const double> vertex_area, std::span<glm::dvec3> points, Keeps keeps = Keeps::areas);

    /// From now on, \p vertex stays where it is: only put_into_kernel() moves it.
    void pin(Index vertex) { is_pinned_[vertex] = 1; }

    /// Computes the rest shapes of all triangles anew, blended towards equilateral so that needles and
    /// triangles without area do not demand the impossible.
    /// \param blend  0 to 1
    void update_shapes(double blend);
    /// The same for the triangles at \p vertex.
    void update_shapes_at(Index vertex, double blend);

    /// Moves \p vertex by one Newton step, unless it is pinned.
    /// \return the relative decrease of the energy of its star
    double relax(Index vertex);

    /// Moves \p vertex and its neighbors by a few steps, except neighbors with very many edges.
    void relax_star(Index vertex);

    /// The smallest ratio of spherical area to target area among the triangles at \p vertex.
    double min_share(Index vertex) const;

    /// Relaxes \p vertex and its neighbors, then the vertices that moved and their neighbors, and so on, in
    /// at most \p steps moves. Counts one step of \p meter per move.
    void relax_around(Index vertex, int steps, ProgressMeter& meter);

    /// Moves \p vertex to the middle of its star's kernel.
    /// \param seed  a point of the closure of the kernel
    /// \return      false if doubles do not resolve the kernel
    bool put_into_kernel(Index vertex, const glm::dvec3& seed);

    /// Relaxes all vertices, and then again the vertices that moved and their neighbors, at most \p sweeps
    /// times. Counts one step of \p meter per vertex and sweep.
    void sweep(int sweeps, ProgressMeter& meter);

    /// Moves vertices that lie outside the kernels of their stars into these kernels, in at most \p sweeps
    /// sweeps. Pinned vertices stay; their neighbors have to make room. Counts one step of \p meter per vertex that is
    /// examined.
    /// \return whether no such vertex is left
    bool untangle(int sweeps, ProgressMeter& meter);

  private:
    void activate_star(Index vertex);
    void update_shape(Index triangle, double blend);
    void gather(Index vertex, const glm::dvec3& center);

    const HalfEdgeMesh& mesh_;
    std::span<const glm::dvec3> positions_;
    std::span<const double> vertex_area_;
    std::span<glm::dvec3> points_;
    std::vector<double> cotangent_;  // per half-edge, of the rest angle opposite it
    std::vector<double> area_;       // per triangle, as a part of 4 pi
    std::vector<char> is_active_;
    std::vector<char> is_pinned_;
    std::vector<Index> waiting_;  // active vertices, in the order in which they are moved
    SphericalStar star_;
};

}  // namespace interleaf
