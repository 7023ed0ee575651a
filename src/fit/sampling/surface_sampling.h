// Samples a surface that is mapped to the sphere, over root triangles there, and so makes the leaves of a
// key.
//
// The vertices of a leaf are points of the sphere, and lie where the map puts these points on the surface.
// The leaf with the largest error is bisected next, at the middle of its refinement edge on the sphere. The
// error is the distance of the leaf from the surface plus a term for the turn of the normal. It is measured
// at a few places of the leaf and at all vertices of the surface that are mapped into the leaf; without these
// vertices, thin parts would be missed. If a landmark in the leaf is farther than that from the leaf's point in its
// direction, this distance is the error. Leveling comes last: it measures the distance alone, closely, and
// bisects the farthest leaves.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "fit/sampling/mapped_surface.h"
#include "fit/sphere_map/sphere_roots.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/progress.h"

namespace interleaf {

struct SamplingOptions {
    Index leaves = 20000;       ///< maximum, reached as closely as closure allows
    Index max_leveling = 2000;  ///< number of leaves kept for leveling, at most a tenth of all

    /// If not 0: bisects, apart from closure, only the leaves that are farther than this from the surface, or from a
    /// landmark in its direction, when they are made, in the unit of the surface. Their neighbors may change later,
    /// so the caller must measure the key.
    double tolerance = 0;
};

/// Leaves in preorder. The leaves hold indices of vertices; root vertices come first.
struct SampledSurface {
    std::vector<Leaf> leaves;
    std::vector<glm::vec3> positions;
    std::vector<glm::dvec3> sphere_points;
    std::vector<MeshPoint> mesh_points;  ///< per vertex, its place on the surface
};

/// \throw Cancelled
SampledSurface sample_surface(const MappedSurface& mapped, const SphereRoots& roots,
                              const SamplingOptions& options, const Progress& progress);

/// Whether the normal of a leaf does not point to the same side as the mean normal of the surface over a few places of
/// the leaf, found by the map. A leaf without area faces away.
/// \param leaf  vertices of \p surface
bool faces_away(const Triangle& leaf, const SampledSurface& surface, const MappedSurface& mapped);

/// Whether a leaf faces away from the surface at all of these places. A leaf around a sharp edge, with one side of a
/// blade at some places and the other side at others, faces away from one of the two whatever it does; that does not
/// turn it over.
/// \param leaf  vertices of \p surface
bool is_turned_over(const Triangle& leaf, const SampledSurface& surface, const MappedSurface& mapped);

}  // namespace interleaf
