// Reduces a closed mesh of genus 0 to a tetrahedron, one half-edge collapse at a time.
//
// The cost is isotropic: the length of the longest edge that a collapse makes, times the worst shape of the
// triangles that it makes, relative to the worst shape of the triangles that it removes. So the triangles of
// the coarse meshes are close to equilateral, and needles are removed first. The map needs good shapes more
// than closeness to the surface. (Praun and Hoppe 2003 use a quadric error, which leaves long thin triangles
// that do not fit on a coarse sphere.)
//
// On a plate as thick as its edges are long, the shortest edges are at the rim, again and again. So the plate would
// erode from the rim to a tetrahedron of the size of one edge, and a map that begins there has to unfold it. So where
// area is lost almost as fast as vertices, all begins anew, with a cost that counts how far the surface moves, too.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"

namespace interleaf {

/// Collapses \p mesh to four vertices. Counts one step of \p meter per vertex, up to the fraction
/// \p last_part of the whole.
/// \param kept  per vertex, not 0 for vertices that go only when no other vertex can; empty for none
/// \return the collapsed half-edges, in order
/// \pre    \p mesh is a simplicial complex and a sphere; no coordinate in \p positions is beyond about 1e30
std::vector<Index> decimate(HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions, ProgressMeter& meter,
                            double last_part, std::span<const char> kept = {});

}  // namespace interleaf
