// A surface that is mapped to the sphere, sampled over root triangles there: the leaves of a key.
//
// A leaf's vertices are points of the sphere, and lie where these are mapped to on the surface. The leaf of
// the largest error is bisected next, at the middle of its refinement edge on the sphere. Its error is its
// distance from the surface plus a term for the turn of the normal, measured at a few places of it and at all
// vertices of the surface that are mapped into it: without those, what is thin is missed.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/progress.h"
#include "fit/sphere_location.h"
#include "fit/sphere_roots.h"
#include "fit/surface_mesh.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

struct SamplingOptions {
    Index leaves = 20000;  ///< at most this many, and as near as closure allows
    double tolerance =
        0;  ///< stop when no leaf is farther from the surface, in its unit; 0: leaves alone count
};

/// Leaves in preorder; what belongs to a vertex is indexed by the numbers used in the leaves, root vertices
/// first.
struct SampledSurface {
    std::vector<Leaf> leaves;
    std::vector<glm::vec3> positions;
    std::vector<glm::dvec3> sphere_points;
    std::vector<MeshPoint> mesh_points;  ///< where on the surface a vertex lies
};

/// \param mesh      closed, of genus 0
/// \param points    its map to the unit sphere, one a vertex, bijective
/// \param location  of that map
/// \throw Cancelled
SampledSurface sample_surface(const SurfaceMesh& mesh, std::span<const glm::dvec3> points,
                              const SphereLocation& location, const SphereRoots& roots,
                              const SamplingOptions& options, const Progress& progress);

}  // namespace interleaf
