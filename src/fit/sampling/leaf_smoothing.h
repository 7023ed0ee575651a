// The last step of the sampling: vertices of the worst leaves move along the surface.
//
// Once leaves are no longer bisected, a vertex of a key may lie anywhere on the surface, as long as its
// leaves stay one to one with their parts of the sphere. Where leaves have a small angle or are turned over
// against the surface, their vertices look for better places nearby. No move makes the least angle of its
// star smaller, as far as it is small, or turns more of its leaves over, and after it the star is nearer
// to the mesh than the farthest place was, where that is measured.
#pragma once

#include <cstddef>
#include <limits>

#include "fit/mesh/progress.h"
#include "fit/sampling/mapped_surface.h"
#include "fit/sampling/surface_sampling.h"

namespace interleaf {

/// Leaves with a smaller angle than this, in degrees, are smoothed.
inline constexpr double smoothed_angle = 18;

/// Moves vertices of \p surface so that its least angle does not fall and no more leaves are turned over
/// (surface_sampling.h). The mesh over a star that has changed is nearer to it than the farthest place of the
/// mesh was, at its vertices and on a grid over the leaves; between these it may be a little farther.
/// \param surface         sampled from \p mapped
/// \param fixed_vertices  the first so many stay where they are: those of the roots
/// \param max_tries      no further round begins when so many vertices have looked for better places
/// \throw Cancelled
void smooth_leaves(const MappedSurface& mapped, std::size_t fixed_vertices, SampledSurface& surface,
                   const Progress& progress, std::size_t max_tries = std::numeric_limits<std::size_t>::max());

/// The leaves that smooth_leaves() tries to mend: of a small angle, or turned over.
std::size_t count_faulty_leaves(const MappedSurface& mapped, const SampledSurface& surface);

}  // namespace interleaf
