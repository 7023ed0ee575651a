// Takes a closed mesh of genus 0 down to a tetrahedron, one half-edge collapse at a time.
//
// The cost is isotropic: the length of the longest edge that a collapse makes, times the worst shape of the
// triangles that it makes, relative to the worst of those that it takes away. So the coarse meshes have
// triangles near to equilateral, which the map needs more than nearness to the surface (Praun and Hoppe 2003
// use a quadric error, which leaves long thin triangles that do not fit on a coarse sphere), and needles go
// first.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"

namespace interleaf {

/// Collapses \p mesh to four vertices and gives the collapsed half-edges in order. One step of \p meter a
/// vertex, up to the part \p last_part of the whole. \pre the mesh is a simplicial complex and a sphere; \p
/// positions have no coordinate beyond about 1e30
std::vector<Index> decimate(HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions, ProgressMeter& meter,
                            double last_part);

}  // namespace interleaf
