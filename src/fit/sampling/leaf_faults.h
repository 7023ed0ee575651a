// The faults of leaves that smoothing mends: small angles, and leaves that face away from the surface.
#pragma once

#include <cstddef>

#include "fit/mesh/space_triangle.h"
#include "fit/sampling/mapped_surface.h"
#include "fit/sampling/surface_sampling.h"

namespace interleaf {

/// Leaves with an angle below this one, in degrees, are faulty.
inline constexpr double smoothed_angle = 18;

double cosine_of_degrees(double degrees);

/// The cosine of the least angle; 1 for a triangle without area.
double max_cosine(const TriangleCorners& corners);

/// \param leaf  vertices of \p surface
TriangleCorners corners_of(const Triangle& leaf, const SampledSurface& surface);

/// Number of leaves with a smaller angle than \p degrees.
std::size_t count_needles(const SampledSurface& surface, double degrees);

/// Number of leaves that smooth_leaves() tries to improve.
std::size_t count_faulty_leaves(const MappedSurface& mapped, const SampledSurface& surface);

}  // namespace interleaf
