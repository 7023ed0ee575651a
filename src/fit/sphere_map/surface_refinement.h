// Makes a finer mesh of the same surface, for surfaces with large or long triangles.
//
// A map to the sphere is linear on each triangle. Where a face of the surface is one triangle, or a fan of
// needles, these triangles force the map to distort the surroundings of the face. On a finer mesh the map can
// keep shapes. Refinement alternates two steps: it flips edges inside flat faces until they are Delaunay
// (Lawson 1977), and it halves the longest edges. No vertex moves and no crease is flipped, so the surface
// stays the same set of points, unless the options allow a deviation.
#pragma once

#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_mesh.h"

namespace interleaf {

struct RefinementOptions {
    /// Edges are halved if they are longer than the edges of this many equilateral triangles with the
    /// surface's area.
    double triangles = 3000;

    /// The largest number of added triangles. Long creases would take more.
    std::size_t max_added = 40000;

    /// How far a flip may move a point of the surface, as a fraction of the longest side of its box. Files
    /// store so few digits that flat faces are only flat to about this fraction.
    double flatness = 1e-6;

    /// If larger than flatness, edges inside gently curved faces are flipped, too, if the middle of the new edge
    /// is within this distance of the surface, as a fraction of the longest side of its box. The result then only
    /// approximates the surface, but where the surface consists of long needles, it has fewer and rounder
    /// triangles. Its vertices lie on the surface.
    double deviation = 0;
};

/// Fractions of the area of a surface.
struct TriangleShapes {
    double large =
        0;  ///< in triangles with a side longer than those of 750 equilateral ones of the same area
    double needles = 0;  ///< in triangles more than ten times as long as high
};

TriangleShapes triangle_shapes(const SurfaceMesh& mesh);

/// \param mesh  clean (clean_up.h)
/// \return the vertices of \p mesh, in order, then the new ones; without colors
/// \throw Cancelled
SurfaceMesh refine(const SurfaceMesh& mesh, const RefinementOptions& options, ProgressMeter& meter);

}  // namespace interleaf
