// Makes a mesh from a file into one closed, oriented surface of genus 0, or says why that cannot be.
//
// In this order: equal points are welded; triangles without three vertices and double ones go; where more
// than two triangles meet at an edge, they are parted (see edge_pairing.h); the component of the largest area
// is kept; its triangles are turned to agree; vertices at which it touches itself are split, edges that join
// the same two vertices twice get midpoints; holes are filled; the surface is turned outward. No point is
// moved.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/progress.h"
#include "fit/surface_mesh.h"

namespace interleaf {

/// What was done, in counts.
struct CleanUpReport {
    std::size_t welded_vertices = 0;       ///< that went into an equal one
    std::size_t degenerate_triangles = 0;  ///< that named a point twice
    std::size_t duplicate_triangles = 0;   ///< of the same three points as another
    std::size_t crowded_edges = 0;         ///< at which more than two triangles met
    std::size_t dropped_components = 0;
    std::size_t dropped_triangles = 0;  ///< of dropped components
    std::size_t split_vertices = 0;     ///< added where the surface touches itself at a point
    std::size_t split_edges = 0;        ///< of two that joined the same vertices, given a midpoint
    std::size_t turned_triangles = 0;   ///< that disagreed with their neighbours
    std::size_t holes = 0;              ///< filled
    std::size_t hole_triangles = 0;     ///< added to fill them
    bool turned_outward = false;        ///< the whole surface looked inward

    /// A sentence for each thing that was done; none for a clean mesh.
    std::vector<std::string> sentences() const;
};

struct CleanMesh {
    SurfaceMesh mesh;
    CleanUpReport report;
    std::vector<Index> source_vertex;  ///< of each vertex, the input's; no_index for added ones
};

/// Vertices and triangles keep their order; a clean mesh comes back as it was, less vertices that no triangle
/// uses.
/// \throw InputError saying what is wrong and where, unless the result is closed, oriented and of Euler
/// number 2 \throw Cancelled  when \p progress says so
CleanMesh clean_up(SurfaceMesh mesh, const Progress& progress);

}  // namespace interleaf
