// Makes a mesh from a file into one closed, oriented surface of genus 0, or says why that cannot be.
//
// In this order: equal points are welded, and points along seams that are equal but for rounding; triangles
// without three vertices and double ones go; where more than two triangles meet at an edge, they are parted
// (see edge_pairing.h); the component of the largest area is kept; its triangles are turned to agree;
// vertices at which it touches itself are split, edges that join the same two vertices twice get midpoints;
// holes are filled; the surface is turned outward. No point is moved.
#pragma once

#include <vector>

#include "fit/clean_up/clean_up_report.h"
#include "fit/mesh/progress.h"
#include "fit/mesh/surface_mesh.h"

namespace interleaf {

struct CleanMesh {
    SurfaceMesh mesh;
    CleanUpReport report;
    std::vector<Index> source_vertex;  ///< of each vertex, the input's; no_index for added ones
    SurfaceMesh dropped;               ///< components of the input that are not kept, without colors
};

/// Vertices and triangles keep their order; a clean mesh comes back as it was, less vertices that no triangle
/// uses.
/// \throw InputError saying what is wrong and where, unless the result is closed, oriented and of Euler
/// number 2 \throw Cancelled  when \p progress says so
CleanMesh clean_up(SurfaceMesh mesh, const Progress& progress);

}  // namespace interleaf
