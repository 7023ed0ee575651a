// How well a sampled surface represents the original surface, and whether that is good enough.
#pragma once

#include <span>
#include <string>

#include "fit/mesh/surface_mesh.h"
#include "fit/sampling/surface_sampling.h"
#include "hierarchy/progress.h"

namespace interleaf {

/// A mesh that another object owns.
struct MeshView {
    std::span<const Triangle> triangles;
    std::span<const glm::dvec3> positions;
};

/// The largest distance of a point of either mesh from the other mesh, measured at the same places as in
/// measure_quality().
/// \throw Cancelled
double hausdorff_distance(const MeshView& a, const MeshView& b, const Progress& progress);

/// Lengths are fractions of the box diagonal of the surface.
struct FitQuality {
    double hausdorff = 0;            ///< largest distance of a point of either surface from the other
    double root_mean_square = 0;     ///< of the distances from the surface to the key and back, by area
    double min_angle = 0;            ///< degrees
    std::size_t flipped_leaves = 0;  ///< see is_turned_over()
    int euler = 0;
};

/// Measures everything except the distances, which stay 0.
FitQuality measure_shapes(const MappedSurface& mapped, const SampledSurface& surface);

/// Measures at the vertices of both surfaces, and on grids over their triangles: about 100,000 places on
/// each, more where the meshes are finer. Between these places distances may be a little larger than
/// measured.
/// \throw Cancelled
FitQuality measure_quality(const MappedSurface& mapped, const SampledSurface& surface,
                           const Progress& progress);

/// The same, with distances from \p original. The mesh in \p mapped is another mesh of the same surface
/// (surface_refinement.h).
FitQuality measure_quality(const MappedSurface& mapped, const SurfaceMesh& original,
                           const SampledSurface& surface, const Progress& progress);

/// The acceptance of a fit, judged at 20,000 leaves.
struct FitLimits {
    double hausdorff = 0.005;     ///< fraction of the box diagonal
    double flipped_part = 0.005;  ///< fraction of the leaves
};

/// Why a fit is not accepted; empty if it is accepted.
std::string fault_of_fit(const FitQuality& quality, std::size_t leaves, const FitLimits& limits = {});

}  // namespace interleaf
