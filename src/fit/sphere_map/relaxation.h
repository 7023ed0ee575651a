// Relaxes a map of a mesh to the sphere: moves one vertex after the other to where its star is distorted
// least.
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
    /// \param mesh         may be collapsed and restored between the calls, with update_shapes() after it
    /// \param positions    on the surface, one a vertex
    /// \param vertex_area  the part of 4 pi that the surface around each vertex is to take
    /// \param points       on the unit sphere, one a vertex; those that the mesh has are moved
    Relaxation(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
               std::span<const double> vertex_area, std::span<glm::dvec3> points, Keeps keeps = Keeps::areas);

    /// Takes the rest shapes of all triangles anew. They are blended towards equilateral, by 0 to 1, so that
    /// needles and triangles of no area do not ask for the impossible.
    void update_shapes(double blend);
    /// The same for the triangles at \p vertex.
    void update_shapes_at(Index vertex, double blend);

    /// Moves \p vertex by one Newton step and gives by how much of it the energy of its star falls.
    double relax(Index vertex);

    /// Moves \p vertex and its neighbors, but for those of very many edges, by a few steps.
    void relax_star(Index vertex);

    /// The least ratio of the spherical area of a triangle at \p vertex to the one that it is to take.
    double min_share(Index vertex) const;

    /// Relaxes \p vertex and its neighbors, then those that moved and their neighbors, and so on, in at
    /// most \p steps moves. One step of \p meter a move.
    void relax_around(Index vertex, int steps, ProgressMeter& meter);

    /// Puts \p vertex into the middle of its star's kernel, seen from the point \p seed of the kernel's
    /// closure; false when doubles do not resolve the kernel.
    bool put_into_kernel(Index vertex, const glm::dvec3& seed);

    /// Relaxes all vertices, and again those that moved and their neighbors, at most \p sweeps times.
    /// One step of \p meter a vertex and sweep.
    void sweep(int sweeps, ProgressMeter& meter);

    /// Puts vertices that are outside of their stars' kernels into them, where there are any, at most \p
    /// sweeps times; whether none is left. One step of \p meter a vertex and sweep.
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
    std::vector<double> area_;       // per triangle, of 4 pi
    std::vector<char> is_active_;
    std::vector<Index> waiting_;  // active vertices in the order of their turns
    SphericalStar star_;
};

}  // namespace interleaf
