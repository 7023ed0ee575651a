// Brings a mapped mesh that only approximates a surface nearer to the surface.
//
// The side of a cylinder of many edges is a ring of needles. Its own mesh, however refined, consists of needles
// too, and takes long to map. A mesh of rounder triangles that approximates the surface (deviation in
// surface_refinement.h) is mapped in a fraction of that time, and better. Afterwards the mesh is made finer
// where it is away from the surface. This does not change the map.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_mesh.h"

namespace interleaf {

/// Halves the edges of \p mesh whose middles are farther from the surface than \p tolerance, and puts the new
/// vertices onto the surface. On the sphere, the new vertices are at the middles of the edges, so the map stays
/// one to one but for rounding. Ends after a few rounds even if some edges are still too far away.
/// \param surface    the surface itself
/// \param mesh       approximates the surface; its vertices come first in the result, in order
/// \param points     of the unit sphere, one per vertex of \p mesh; receives those of the new vertices
/// \param tolerance  in the units of the positions
/// \throw Cancelled
void approximate_closely(const SurfaceMesh& surface, SurfaceMesh& mesh, std::vector<glm::dvec3>& points,
                         double tolerance, ProgressMeter& meter);

}  // namespace interleaf
