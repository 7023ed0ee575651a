// A surface that is mapped to the sphere, sampled over root triangles there: the leaves of a key.
//
// A leaf's vertices are points of the sphere, and lie where these are mapped to on the surface. The leaf of
// the largest error is bisected next, at the middle of its refinement edge on the sphere. Its error is its
// distance from the surface plus a term for the turn of the normal, measured at a few places of it and at all
// vertices of the surface that are mapped into it: without those, what is thin is missed. At last comes
// leveling: the distance alone is measured, closely, and the farthest leaves are bisected.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/progress.h"
#include "fit/sampling/mapped_surface.h"
#include "fit/sphere_map/sphere_roots.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

struct SamplingOptions {
    Index leaves = 20000;       ///< at most this many, and as near as closure allows
    Index max_leveling = 2000;  ///< so many of the leaves, but at most a tenth, are for leveling

    /// Where it is not 0: leaves are bisected that are farther from the surface when they are made, in its
    /// unit, and no others but by closure. Their neighbors may change later, so the key is to be measured.
    double tolerance = 0;
};

/// Leaves in preorder; what belongs to a vertex is indexed by the numbers used in the leaves, root vertices
/// first.
struct SampledSurface {
    std::vector<Leaf> leaves;
    std::vector<glm::vec3> positions;
    std::vector<glm::dvec3> sphere_points;
    std::vector<MeshPoint> mesh_points;  ///< where on the surface a vertex lies
};

/// \throw Cancelled
SampledSurface sample_surface(const MappedSurface& mapped, const SphereRoots& roots,
                              const SamplingOptions& options, const Progress& progress);

/// Whether the normal of a leaf does not point to the side of the surface's normal there: the mean over a few
/// places of the leaf, by the map. A leaf of no area counts.
/// \param leaf  vertices of \p surface
bool is_turned_over(const Triangle& leaf, const SampledSurface& surface, const MappedSurface& mapped);

}  // namespace interleaf
