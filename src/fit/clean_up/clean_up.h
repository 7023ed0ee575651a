// Turns a mesh from a file into one closed, oriented surface of genus 0, or says why that is impossible.
//
// The steps, in this order:
// - weld vertices at equal points, and vertices along seams that differ only by rounding
// - remove degenerate and duplicate triangles
// - separate the surfaces at edges where more than two triangles meet (edge_pairing.h)
// - keep the component with the largest area
// - turn triangles over until neighbors agree
// - split vertices at which the surface touches itself, and give a midpoint to one of two edges that join the
//   same two vertices
// - fill holes
// - turn the surface outward
//
// No step moves a point.
#pragma once

#include <vector>

#include "fit/clean_up/clean_up_report.h"
#include "fit/mesh/surface_mesh.h"
#include "hierarchy/progress.h"

namespace interleaf {

struct CleanMesh {
    SurfaceMesh mesh;
    CleanUpReport report;
    std::vector<Index> source_vertex;  ///< per vertex, its index in the input; no_index for added vertices
    SurfaceMesh dropped;  ///< the components of the input that are not kept, without colors and scalars
};

/// Vertices and triangles keep their order. A clean mesh comes back unchanged, except that vertices that no
/// triangle uses are dropped.
/// \throw InputError  saying what is wrong and where, unless the result is closed, oriented and of Euler
///                    number 2
/// \throw Cancelled   when \p progress says so
CleanMesh clean_up(SurfaceMesh mesh, const Progress& progress);

}  // namespace interleaf
