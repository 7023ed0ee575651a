// A surface that moves: an adaptive mesh whose vertices change their positions from step to step, and that is
// refined and coarsened by the errors of its edges after a step.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/field.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

/// The distance of the surface from the middle of the straight edge between the vertices \p a and \p b; never
/// negative.
using EdgeError = std::function<double(Index a, Index b)>;

class EvolvingMesh {
  public:
    /// The position of a new vertex \p midpoint on the edge between \p a and \p b. The mesh calls the rule
    /// once per new vertex, so a caller can keep arrays beside the mesh. It may reuse the index of a vertex
    /// that adapt() has removed.
    using PlaceMidpoint = std::function<glm::dvec3(Index a, Index b, Index midpoint)>;

    /// The unrefined roots.
    /// \param positions  one per root vertex
    EvolvingMesh(const RootComplex& roots, std::vector<glm::dvec3> positions, PlaceMidpoint place);

    /// The leaves and their neighbors. The positions of this mesh are those at which the vertices were made.
    const AdaptiveMesh& mesh() const { return mesh_; }

    /// The present positions by vertex, up to mesh().vertex_bound(); meaningless at freed indices. A step
    /// moves the vertices here.
    std::span<glm::dvec3> positions() { return positions_; }
    std::span<const glm::dvec3> positions() const { return positions_; }

    /// The vertices of all leaves, root after root, in the preorder of their trees.
    std::vector<Triangle> triangles() const;

    /// Refines the mesh until no edge of a leaf has an error above \p tolerance. Then coarsens it, where all
    /// edges of the leaves that come back have errors of at most half of \p tolerance.
    /// \param prepare  called before the errors are requested, and again after every change of the mesh
    /// \throw InputError if a leaf would exceed the level max_level or the mesh the number max_leaves of
    ///     leaves
    void adapt(const EdgeError& error, double tolerance, const std::function<void()>& prepare = {});

    /// The frozen hierarchy of the present leaves and positions.
    /// \param fields  the fields of the hierarchy, with values up to mesh().vertex_bound()
    Hierarchy freeze(std::span<const Field> fields) const;

    /// The limit of the number of leaves. A tolerance that needs more is too small for a sequence.
    static constexpr Index max_leaves = 2'000'000;

  private:
    std::vector<Index> leaves_to_refine(const EdgeError& error, double tolerance) const;
    std::vector<Index> leaves_to_coarsen(const EdgeError& error, double tolerance) const;

    std::vector<glm::dvec3> positions_;
    std::vector<std::array<Index, 2>> ends_;  ///< of the edge that each midpoint bisects
    PlaceMidpoint place_;
    AdaptiveMesh mesh_;
};

}  // namespace interleaf
