// Fills the holes of an oriented manifold with rings of ever fewer vertices and a fan in the middle.
//
// All edges within a hole have a new vertex as an end, so filling never joins two vertices twice. A hole of
// three edges is filled with one triangle. The filling is flat only where the hole's rim is.
#pragma once

#include <cstddef>
#include <span>

#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_mesh.h"

namespace interleaf {

struct FilledHole {
    std::size_t edges = 0;      ///< of its rim
    std::size_t triangles = 0;  ///< that fill it
};

/// Appends the vertices and triangles that close \p mesh, hole by hole; the holes in the same order. The new
/// vertices are no more than those on the rims.
/// \pre a manifold whose triangles agree, at most one edge between two vertices, with the twins of its
///      half-edges (see edge_pairing.h)
std::vector<FilledHole> fill_holes(SurfaceMesh& mesh, std::span<const Index> twin, ProgressMeter& meter);

}  // namespace interleaf
