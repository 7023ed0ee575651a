// A finer mesh of the same surface, for surfaces whose triangles are large or long.
//
// A map to the sphere is linear on each triangle, so where a face of the surface is one triangle, or a fan of
// needles, the map bends the face's neighborhood to what these can do. On a finer mesh it can keep shapes.
// Edges inside of flat faces are flipped until they are Delaunay's (Lawson 1977), and the longest edges are
// halved, in turn. No vertex moves and no crease is flipped, so the surface stays the same set of points.
#pragma once

#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_mesh.h"

namespace interleaf {

struct RefinementOptions {
    /// Edges are halved that are longer than those of so many equilateral triangles of the surface's area.
    double triangles = 3000;

    /// The end, where long creases would take more: so many triangles more than before.
    std::size_t max_added = 40000;

    /// How far a flip may move a point of the surface, as a fraction of the longest side of its box. It is
    /// what the digits of files leave of flat faces.
    double flatness = 1e-6;
};

/// Parts of a surface's area.
struct TriangleShapes {
    double large =
        0;  ///< in triangles with a side longer than those of 750 equilateral ones of the same area
    double needles = 0;  ///< in triangles more than ten times as long as high
};

TriangleShapes triangle_shapes(const SurfaceMesh& mesh);

/// \param mesh  clean (clean_up.h)
/// \return its vertices, in order, then the new ones; without colors
/// \throw Cancelled
SurfaceMesh refine(const SurfaceMesh& mesh, const RefinementOptions& options, ProgressMeter& meter);

}  // namespace interleaf
