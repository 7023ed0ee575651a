// Parts a surface where it touches itself, so that it is a manifold and a simplicial complex.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_mesh.h"

namespace interleaf {

/// Gives each fan of triangles around a vertex a vertex of its own, drops unused vertices and renumbers the
/// rest in their old order.
/// \param twin  of the half-edges (see edge_pairing.h); the triangles agree
/// \return      for each vertex, the one that it was
std::vector<Index> split_vertices(SurfaceMesh& mesh, std::span<const Index> twin, ProgressMeter& meter);

/// Bisects all but one of the edges that join the same two vertices; how many. \p twin is kept up to date.
std::size_t split_double_edges(SurfaceMesh& mesh, std::vector<Index>& twin, ProgressMeter& meter);

}  // namespace interleaf
