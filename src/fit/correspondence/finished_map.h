// The last steps of matching: the vertices of a matched body that its moving mesh lacks return, and shapes on the
// sphere improve.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/correspondence/even_mesh.h"
#include "fit/correspondence/sphere_mesh.h"
#include "fit/mesh/progress_meter.h"

namespace interleaf {

/// The matched map of the whole \p body.
/// \param coarse     \p body on fewer of its vertices; gets all of them back
/// \param on_sphere  the matched map of \p coarse, one to one: one point per vertex
/// \return           points of the unit sphere, one per vertex of \p body; none if there is no room for a vertex
/// \throw Cancelled
std::vector<glm::dvec3> finished_map(const SphereMesh& body, CoarsenedMesh& coarse,
                                     std::span<const glm::dvec3> on_sphere, ProgressMeter& meter);

/// In so many sweeps, most shapes are restored. A long thin part, such as a tail, comes to rest in a thousand.
inline constexpr int usual_sweeps = 30;

/// Relaxes a map that is one to one where triangles have bad shapes on the sphere, which would give leaves that are
/// needles or flipped. Landmarks get their directions to the last bit and stay there; if that turns triangles over,
/// these are untangled. The result may still not be one to one then: see fault_of_map().
/// \param worst   the conformal distortion (MIPS) from which on a triangle and its surroundings are relaxed; 1 for all
/// \param sweeps  at most
/// \return whether there are such triangles
/// \throw Cancelled
bool restore_shapes(const SphereMesh& body, double worst, int sweeps, std::vector<glm::dvec3>& points,
                    ProgressMeter& meter);

}  // namespace interleaf
