// How well a sampled surface stands for the one it was made from, and whether that is good enough.
#pragma once

#include <span>
#include <string>

#include "fit/mesh/progress.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sampling/surface_sampling.h"

namespace interleaf {

/// The diagonal of the box around a mesh, its sides along the axes.
double box_diagonal(const SurfaceMesh& mesh);

/// A mesh that somebody else keeps.
struct MeshView {
    std::span<const Triangle> triangles;
    std::span<const glm::dvec3> positions;
};

/// The largest distance of a point of either mesh from the other, at places as measure_quality() takes them.
/// \throw Cancelled
double hausdorff_distance(const MeshView& a, const MeshView& b, const Progress& progress);

/// Lengths are parts of the box diagonal of the surface.
struct FitQuality {
    double hausdorff = 0;         ///< largest distance of a point of either from the other
    double root_mean_square = 0;  ///< of the distances from the surface to the key and back, by area
    double min_angle = 0;         ///< degrees
    std::size_t flipped_leaves =
        0;  ///< whose normal is turned by a right angle or more against the surface's
    int euler = 0;
};

/// Measures all but the distances, which stay 0.
FitQuality measure_shapes(const MappedSurface& mapped, const SampledSurface& surface);

/// Measures at the vertices of both, and on grids over their triangles: some 100,000 places each, more where
/// the meshes are finer. So distances are as large as found, and may be a little larger between these places.
/// \throw Cancelled
FitQuality measure_quality(const MappedSurface& mapped, const SampledSurface& surface,
                           const Progress& progress);

/// The same, with distances from \p original, of which \p mapped has another mesh (surface_refinement.h).
FitQuality measure_quality(const MappedSurface& mapped, const SurfaceMesh& original,
                           const SampledSurface& surface, const Progress& progress);

/// The acceptance of a fit, judged at 20,000 leaves.
struct FitLimits {
    double hausdorff = 0.005;     ///< part of the box diagonal
    double flipped_part = 0.005;  ///< of the leaves
};

/// Why a fit is not accepted; empty when it is.
std::string fault_of_fit(const FitQuality& quality, std::size_t leaves, const FitLimits& limits = {});

}  // namespace interleaf
