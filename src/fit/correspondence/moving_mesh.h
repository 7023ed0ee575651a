// The mesh of one body, moving over the surface of another one.
//
// Each vertex lies on the other body's surface, and so at a point of the other body's map to the sphere. All
// triangles stay positive there, by exact signs, so the mesh covers the other body once whatever happens. The
// mesh can be coarsened by collapses that are undone later. Landmarks that both bodies have lie on each other, and
// stay there.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "fit/correspondence/distortion.h"
#include "fit/correspondence/matched_body.h"
#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"

namespace interleaf {

/// Weights of the terms of the energy, for bodies of area 1.
struct MatchWeights {
    double position = 30;     ///< squared distances, after the best affine map
    double normal = 1;        ///< squared differences of smoothed normals
    double outwardness = 20;  ///< squared differences
    double distortion = 0.3;  ///< see distortion.h
    std::size_t level = 0;    ///< of smoothing
};

/// The weights for a mesh of \p vertices vertices: the finer the mesh, the less the terms that compare places
/// weigh, and the less the normals are smoothed.
MatchWeights weights_at(double vertices);

/// How well the bodies agree at corresponding places.
struct MatchFigures {
    double energy = 0;       ///< with the distortion of each triangle capped
    double distortion = 0;   ///< 1 if all triangles keep their shapes and sizes
    double mean_cosine = 0;  ///< between the normals of corresponding triangles, by area
    double stretched = 0;    ///< the part of the area that is stretched or shrunk more than 8 times
};

class MovingMesh {
  public:
    /// Where the vertices are on the other body.
    struct Places {
        std::vector<MeshPoint> on_mesh;
        std::vector<glm::dvec3> in_space;
        std::vector<glm::dvec3> on_sphere;
    };

    /// \param moving  the body whose even mesh moves; must outlive this object
    /// \param onto    must outlive this object
    MovingMesh(const MatchedBody& moving, const MatchedBody& onto, ProgressMeter& meter);

    /// Puts each vertex where the other body's map has its point.
    /// \param points  a map of the moving mesh, one to one: one point of the unit sphere per vertex
    /// \pre nothing is collapsed beyond the base
    void put_at(std::span<const glm::dvec3> points);
    void put_at_own_points() { put_at(moving_.points()); }

    /// Coarsens the mesh to \p vertices vertices, and makes the result the base to which refine() returns.
    /// \pre nothing is collapsed
    void make_base(std::size_t vertices);

    /// Forgets the base: refine() returns to all vertices again.
    void leave_base() { base_ = 0; }

    /// From now on, no vertex moves to a place where it makes needles on the sphere. The mesh is then easily relaxed
    /// there, too, but there may be less room.
    void avoid_needles() { avoids_needles_ = true; }

    std::size_t count() const { return count_; }
    const Places& places() const { return places_; }
    /// \pre nothing is collapsed beyond the base
    void set_places(const Places& places);

    /// Coarsens the mesh to \p vertices vertices, if it can.
    /// \param variation      see coarsening.h
    /// \param heeds_places   also keeps good shapes on the other body, and removes strained vertices first
    void coarsen_to(std::size_t vertices, std::uint32_t variation, bool heeds_places);

    /// Undoes all collapses beyond the base. Each vertex goes to the best of several places in the kernel of its star.
    /// Whenever the mesh has grown by a quarter, it is relaxed by at most \p sweeps sweeps.
    /// \param until  returns as soon as the relaxed mesh has at least this number of vertices; the next call goes on
    /// \return false if there is no room for a vertex; then the vertices of the base are in no useful places
    bool refine(int sweeps, std::size_t until = std::numeric_limits<std::size_t>::max());

    /// Undoes all collapses beyond the base. The vertices are then in no useful places.
    void restore_all();

    /// Sets the weights, which apply until they are set again.
    void set_weights(const MatchWeights& weights);

    /// Moves one vertex after the other to where the energy is less, then again those that moved and their
    /// neighbors, at most \p sweeps times.
    void relax(int sweeps);

    /// The same in at most 100 sweeps, with distortion weighted \p factor times as much.
    void relax_stiffly(double factor);

    MatchFigures figures();

  private:
    struct StarSide {
        StretchedTriangle triangle;
        glm::dvec3 point_a;  ///< on the sphere
        glm::dvec3 point_b;
        Index index;  ///< of the triangle
    };

    void gather(Index vertex);
    void update_shape(Index triangle);
    void update_shapes_at(Index vertex);
    void list_present();
    void update_masses();
    void fit_affine();
    glm::dvec3 affine_place(Index vertex) const { return linear_ * moving_.positions()[vertex] + offset_; }
    double data_energy(Index vertex, const MeshPoint& place, const glm::dvec3& position) const;
    std::optional<double> energy_below(double limit, Index vertex, const MeshPoint& place,
                                       const glm::dvec3& position) const;
    void hold_landmarks();
    bool is_positive_at(const glm::dvec3& point) const;
    bool is_roomy_at(const glm::dvec3& point) const;
    std::optional<double> try_place(Index vertex, const MeshPoint& place, double energy);
    double relax_vertex(Index vertex);
    double relax_to_middle(Index vertex, double energy);
    void add_data_derivatives(Index vertex, const glm::dvec3& s, const glm::dvec3& t,
                              TangentDerivatives& sum) const;
    bool place_in_kernel(Index vertex, Index kept);
    bool restore(Index half_edge);
    std::vector<Index> vertices_around(Index vertex, int rings) const;
    void relax_for_room(Index vertex);
    void relax_around(Index vertex, int rings, int sweeps);
    void make_room_around(Index vertex, int rings);
    void move_to_middle(Index vertex);
    std::optional<glm::dvec3> kernel_middle(const glm::dvec3& seed) const;
    int sweep();
    int move_active();
    void put(Index vertex, const MeshPoint& place);
    std::vector<char> strained_vertices() const;

    const MatchedBody& moving_;
    const MatchedBody& onto_;
    ProgressMeter& meter_;
    HalfEdgeMesh mesh_;
    std::size_t count_;
    std::vector<Index> vertices_;    ///< that are not collapsed, in order, since list_present()
    std::vector<Index> triangles_;   ///< the same
    std::size_t relaxed_count_ = 0;  ///< number of vertices when the whole mesh was last relaxed
    std::vector<Index> collapses_;
    std::size_t base_ = 0;  ///< number of collapses that refine() does not undo
    Places places_;
    MatchWeights weights_;
    std::vector<double> cotangent_;  ///< per half-edge, of the rest angle at its origin
    std::vector<double> rest_area_;  ///< per triangle
    std::vector<double> mass_;       ///< per vertex, the mean of its areas on both bodies
    std::vector<char> is_active_;
    std::vector<char> is_held_;  ///< 1 per vertex that stays at a landmark of the other body, else 0
    std::vector<StarSide> star_;
    bool avoids_needles_ = false;
    glm::dmat3 rotation_{1};  ///< of this body, by which it agrees best with the other one
    glm::dmat3 linear_{1};
    glm::dvec3 offset_{0};
};

}  // namespace interleaf
