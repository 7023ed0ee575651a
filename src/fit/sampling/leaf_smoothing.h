// The last step of sampling: moves the vertices of the worst leaves along the surface.
//
// Once no more leaves are bisected, a vertex of a key may lie anywhere on the surface, as long as its leaves
// stay one to one with their parts of the sphere. Smoothing looks for better places near the vertices of
// leaves that have a small angle or face away from the surface. No move makes the least angle of a star
// smaller while that angle is small, or lets more of its leaves face away. After a move, the measured
// distance between the star and the mesh is smaller than the largest distance was before, unless it mends a needle.
// Landmarks stay near the key's points in their directions.
#pragma once

#include <cstddef>
#include <limits>

#include "fit/sampling/mapped_surface.h"
#include "fit/sampling/surface_sampling.h"
#include "hierarchy/progress.h"

namespace interleaf {

/// Limits of the work, in vertices that look for better places.
struct SmoothingLimits {
    /// After this many, no round goes through all faulty leaves any more.
    std::size_t tries = std::numeric_limits<std::size_t>::max();
    /// Maximum per round. The worst leaves come first, so the next round goes on with them, not with better ones.
    std::size_t tries_per_round = std::numeric_limits<std::size_t>::max();
    /// Maximum per further round, which goes through the worst leaves only. 0 for no further round.
    std::size_t tries_of_worst = 0;
    /// The worst leaves below this angle, in degrees, are tried once more at the end, at most a hundredth of all or 100,
    /// and where that does not do, with up to 1.25 of the largest distance before, then 1.6. 0: they are not tried.
    /// 18 or less.
    double needle_angle = 0;
    /// But none of these leaves goes farther than this for it, in the unit of the surface.
    double needle_distance = std::numeric_limits<double>::max();
};

/// Moves vertices of \p surface so that its least angle does not fall and no more leaves face away
/// (surface_sampling.h). The mesh over a changed star is nearer to the star than the farthest place of the
/// mesh was before, unless limits.needle_angle says otherwise. This is measured at the vertices of the mesh and on a
/// grid over the leaves; between these places the mesh may be a little farther away.
/// \param surface         sampled from \p mapped
/// \param fixed_vertices  number of vertices at the beginning that do not move: the root vertices
/// \param original        where \p mapped only approximates a surface, that surface. All vertices are put onto it, the
///                        fixed ones, too, which may make leaves a little worse; where it makes needles, they are mended
///                        by limits.needle_angle. Distances are measured to \p mapped.
/// \throw Cancelled
void smooth_leaves(const MappedSurface& mapped, std::size_t fixed_vertices, SampledSurface& surface,
                   const Progress& progress, const SmoothingLimits& limits = {},
                   const SurfaceDistance* original = nullptr);

}  // namespace interleaf
