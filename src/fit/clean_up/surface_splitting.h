// Splits a surface where it touches itself, so that it is a manifold and a simplicial complex.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_mesh.h"

namespace interleaf {

/// Gives each fan of triangles around a vertex its own vertex, drops unused vertices, and renumbers the
/// others in their old order.
/// \param twin  of the half-edges (edge_pairing.h); the triangles agree
/// \return      per vertex, its old index
std::vector<Index> split_vertices(SurfaceMesh& mesh, std::span<const Index> twin, ProgressMeter& meter);

/// Bisects all but one of the edges that join the same two vertices. Keeps \p twin up to date.
/// \return number of edges bisected
std::size_t split_double_edges(SurfaceMesh& mesh, std::vector<Index>& twin, ProgressMeter& meter);

}  // namespace interleaf
