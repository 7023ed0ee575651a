// Which map to the sphere a mesh is sampled by: its own, or that of a finer mesh of the same surface.
//
// Where much of the surface lies in large or long triangles, a refined mesh (surface_refinement.h) is mapped
// too. The refined map is taken where no figure of its key is worse. Where the other key is poor, or its map
// so bad that smoothing takes seconds, the refined key may be a little farther from the surface.
#pragma once

#include <memory>

#include <glm/mat3x3.hpp>

#include "fit/aligned_map.h"
#include "fit/fit_quality.h"
#include "fit/mesh/progress.h"
#include "fit/mesh/stopwatch.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sampling/surface_sampling.h"
#include "fit/sphere_map/sphere_roots.h"
#include "fit/sphere_map/spherical_map.h"

namespace interleaf {

struct MapChoiceOptions {
    const SphereRoots& roots;
    glm::dmat3 rotation;  ///< after the alignment
    Keeps keeps = Keeps::shapes;
    FitLimits limits{};
};

/// A map with the key by which it is judged.
struct JudgedMap {
    std::unique_ptr<const AlignedMap> map;
    SampledSurface surface;  ///< of judged_leaves(), smoothed
    FitQuality quality;      ///< of that surface
    MapMethod method = MapMethod::progressive;
};

/// Leaves of the key by which a map is judged: 20,000, or the roots where these are more.
Index judged_leaves(const SphereRoots& roots);

/// Samples, smooths and measures.
JudgedMap judge(std::unique_ptr<const AlignedMap> map, const SphereRoots& roots, Stopwatch& stopwatch,
                const Progress& progress);

/// Maps, centers, checks, samples and judges a clean mesh.
/// \throw InputError  where no map is one to one
/// \throw Cancelled
JudgedMap choose_map(const SurfaceMesh& mesh, const MapChoiceOptions& options, Stopwatch& stopwatch,
                     const Progress& progress);

}  // namespace interleaf
