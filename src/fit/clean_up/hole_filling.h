// Fills the holes of an oriented manifold. A filling consists of rings with fewer and fewer vertices, and a
// fan in the middle.
//
// Every edge inside a hole has a new vertex as an end, so filling never joins two vertices twice. A hole with
// three edges is filled with one triangle. The filling is flat only if the rim of the hole is flat.
#pragma once

#include <cstddef>
#include <span>

#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_mesh.h"

namespace interleaf {

struct FilledHole {
    std::size_t edges = 0;      ///< of the hole's rim
    std::size_t triangles = 0;  ///< of the filling
};

/// Appends the vertices and triangles that close \p mesh, hole by hole. There are at most as many new
/// vertices as vertices on the rims.
/// \param twin  of the half-edges (edge_pairing.h)
/// \return      the holes, in the order in which they were filled
/// \pre         \p mesh is a manifold whose triangles agree, with at most one edge between two vertices
std::vector<FilledHole> fill_holes(SurfaceMesh& mesh, std::span<const Index> twin, ProgressMeter& meter);

}  // namespace interleaf
