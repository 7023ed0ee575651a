// Conformalized mean curvature flow (Kazhdan, Solomon and Ben-Chen 2012, "Can Mean-Curvature Flow be Modified
// to be Non-singular?"): a surface of genus 0 flows to a sphere without collapsing at its necks. The result
// is nearly conformal, but not always one to one.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"

namespace interleaf {

struct CurvatureFlowOptions {
    double time_step = 0.05;  ///< for a surface of area 1
    int steps = 30;
    double blend = 0.2;  ///< of the triangles' shapes towards equilateral, 0 to 1
};

/// \param positions  within the unit box
/// \return unit vectors, one per vertex: the surface after the flow, projected to a sphere from its middle
std::vector<glm::dvec3> flow_to_sphere(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
                                       const CurvatureFlowOptions& options, ProgressMeter& meter);

/// Calls flow_to_sphere(), untangles the flipped parts of the result, and relaxes it, which gives room to
/// limbs that the flow has shrunk to almost nothing. The result is not always one to one: see fault_of_map().
std::vector<glm::dvec3> map_by_curvature_flow(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
                                              const CurvatureFlowOptions& options, ProgressMeter& meter);

}  // namespace interleaf
