// Recovery by place: the coarsest triangles over all steps of a series, which are the common roots if the steps
// are the leaves of one hierarchy whose vertices stand still in flat roots.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "sequence/series/step_mesh.h"

namespace interleaf {

/// A root complex with the places of its vertices.
struct SeriesRoots {
    RootComplex complex;
    std::vector<glm::dvec3> points;  ///< one per root vertex
};

/// The roots of \p key, with its positions.
SeriesRoots given_roots_of(const Hierarchy& key);

/// The roots that the triangles of \p step are, with their longest edges as refinement edges. The two triangles
/// of a quadrilateral have their common edge as refinement edge.
SeriesRoots roots_of_step(const StepMesh& step);

/// The coarsest triangle at each place, over the steps that were added. Its triangles are a conforming mesh
/// (docs/series.md).
class CoarsestMesh {
  public:
    /// The triangles of the step \p first.
    explicit CoarsestMesh(const StepMesh& first);

    /// The roots \p roots. A step fits only if they contain all of its triangles.
    explicit CoarsestMesh(const SeriesRoots& roots);

    std::size_t triangle_count() const { return triangles_.size(); }

    /// Adds \p step. Where its triangles contain triangles of the mesh, they replace them.
    /// \return a triangle of the step that neither contains nor is contained in triangles of the mesh; no_index
    ///     if there is none. If there is one, the mesh stays as it was
    Index add(const StepMesh& step);

    /// The number of vertices of \p step that are at the place of a vertex of the mesh.
    std::size_t common_vertices(const StepMesh& step) const;

    /// The triangles as roots. Those that no step bisects have the longest edge as refinement edge.
    SeriesRoots roots() const;

  private:
    struct Update;
    void keep_what_step_refines(const StepMesh& step, double tolerance, Update& update) const;
    Index replace_what_step_coarsens(const StepMesh& step, double tolerance, Update& update) const;

    std::vector<glm::dvec3> points_;
    std::vector<Triangle> triangles_;  ///< counter-clockwise
    std::vector<bool> is_marked_;      ///< per triangle: refinement edge known, opposite the first vertex
    double shortest_edge_;
    bool is_fixed_;
};

/// The key whose leaves are the triangles of \p step, over \p roots.
/// \return none if they are not the leaves of a hierarchy over these roots
std::optional<Hierarchy> key_by_place(const StepMesh& step, const SeriesRoots& roots,
                                      const SeriesFields& fields);

}  // namespace interleaf
