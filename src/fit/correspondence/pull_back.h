// Inverts a match of the model's mesh: each vertex of the body takes over the model's point on the sphere.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/correspondence/sphere_mesh.h"
#include "fit/mesh/progress_meter.h"

namespace interleaf {

/// The matched map of \p body. The match is linear on triangles of another mesh, so triangles of \p body may
/// turn over on the sphere. These are untangled, and a few sweeps restore shapes. Landmarks of \p body get their
/// directions to the last bit; where they leave no room to untangle, they are carried there afterwards. The result may still not be one to one: see fault_of_map().
/// \param model      any mesh of the model, with its map
/// \param on_sphere  where the vertices of that mesh are in the map of \p body
/// \return           points of the unit sphere, one per vertex of \p body
/// \throw Cancelled
std::vector<glm::dvec3> pull_back(const SphereMesh& body, const SphereMesh& model,
                                  std::span<const glm::dvec3> on_sphere, ProgressMeter& meter);

/// Moves points of triangles of \p mesh that are turned over on the sphere, and their surroundings. Landmarks stay.
/// Triangles may still be turned over then.
/// \param points  of the unit sphere, one per vertex
/// \throw Cancelled
void untangle(const SphereMesh& mesh, std::vector<glm::dvec3>& points, ProgressMeter& meter);

}  // namespace interleaf
