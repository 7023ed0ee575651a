// The steps of a progressive map (progressive_map.h), so that a caller can stop at a coarse mesh, move its
// vertices over the sphere, and go on from there.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"
#include "fit/sphere_map/progressive_map.h"
#include "fit/sphere_map/relaxation.h"

namespace interleaf {

class ProgressiveMapping {
  public:
    /// \param mesh       a closed simplicial sphere; must outlive this object
    /// \param positions  within the unit box; must outlive this object
    ProgressiveMapping(HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
                       const ProgressiveOptions& options, ProgressMeter& meter);
    ProgressiveMapping(const ProgressiveMapping&) = delete;
    ProgressiveMapping& operator=(const ProgressiveMapping&) = delete;

    /// Reduces the mesh to a tetrahedron, and puts that on the sphere.
    /// \param kept  per vertex, not 0 for vertices that go last (decimation.h); empty for none
    void collapse(std::span<const char> kept = {});

    /// Restores vertices until \p count vertices, or all, are on the sphere, and relaxes the map.
    /// \return whether there was room for them; otherwise, failure() says for which there was none
    bool raise(std::size_t count);

    /// Number of vertices that are on the sphere.
    std::size_t count() const { return restored_; }

    /// Why raise() has failed, in words.
    std::string failure() const;

    /// Undoes the remaining collapses of the mesh, without placing the vertices.
    void restore_mesh();

    const HalfEdgeMesh& mesh() const { return mesh_; }

    /// One unit vector per vertex; only those of the mesh's present vertices mean anything.
    std::vector<glm::dvec3>& points() { return points_; }

    Relaxation& relaxation() { return relaxation_; }

  private:
    void gather_areas();
    void place_tetrahedron();
    bool restore_next();
    void relax_all();

    HalfEdgeMesh& mesh_;
    std::span<const glm::dvec3> positions_;
    ProgressiveOptions options_;
    ProgressMeter& meter_;
    std::vector<double> vertex_area_;
    std::vector<glm::dvec3> points_;
    Relaxation relaxation_;
    std::vector<Index> collapses_;
    std::vector<double> other_area_;  // of the kept vertex, without the removed one's; a collapse
    std::size_t restored_ = 0;        // vertices that are on the sphere
    std::size_t relaxed_ = 0;         // vertices at the last relaxation
    double blend_ = 0;
};

}  // namespace interleaf
