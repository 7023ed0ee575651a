// Chooses the map to the sphere by which a mesh is sampled: the map of the mesh itself, or the map of a finer
// mesh of the same surface.
//
// Where much of the surface lies in large or long triangles, a refined mesh (surface_refinement.h) is mapped
// too; where the surface consists of needles, a mesh that approximates it (surface_approximation.h). The
// refined map is chosen if no figure of its key is worse. If the key of the original map is poor, or the
// original map is so bad that smoothing takes seconds, the refined key may be a little farther from the surface.
// The mesh of needles itself is also mapped if the refined map is bad, or if leaves of its key are needles.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <variant>

#include <glm/mat3x3.hpp>

#include "fit/aligned_map.h"
#include "fit/fit_quality.h"
#include "fit/landmarks/landmark_agreement.h"
#include "fit/mesh/stopwatch.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sampling/surface_sampling.h"
#include "fit/sphere_map/sphere_roots.h"
#include "fit/sphere_map/spherical_map.h"
#include "hierarchy/progress.h"

namespace interleaf {

/// One of several ways to map a surface.
struct MappingWay {
    Keeps keeps = Keeps::shapes;
    /// Whether the surroundings of crowded vertices are relaxed (map_to_sphere()) also where the mesh is mapped as it
    /// is.
    bool relaxes_crowded = false;
};

struct MapChoiceOptions {
    const SphereRoots& roots;
    glm::dmat3 rotation;  ///< applied after the alignment
    MappingWay way{};
    FitLimits limits{};
    /// Vertices of the mesh that lie at given directions; null for none. The map is then neither centered nor
    /// turned.
    const LandmarkPins* pins = nullptr;
    std::span<const glm::dvec3> landmarks{};  ///< positions to which the key is to be near (MappedSurface)
};

/// Whether choose_map() only maps \p mesh as it is, since its triangles are small.
bool is_only_mapped_as_it_is(const SurfaceMesh& mesh);

/// A map, with a key that is not judged yet.
struct FoundMap {
    std::shared_ptr<const AlignedMap> map;
    SampledSurface surface;  ///< of judged_leaves(), not smoothed
    std::size_t faulty = 0;  ///< number of leaves that need smoothing
    FitQuality shapes{};     ///< of that surface, without distances
    MapMethod method = MapMethod::progressive;
    LandmarkAgreement agreement{};  ///< where there are pins
};

/// A map, with the key by which the map is judged.
struct JudgedMap {
    std::shared_ptr<const AlignedMap> map;
    SampledSurface surface;  ///< of judged_leaves(), smoothed unless it is certainly refused
    FitQuality quality;      ///< of that surface
    MapMethod method = MapMethod::progressive;
    LandmarkAgreement agreement{};  ///< where there are pins
};

/// A chosen map. Its key is judged already where the choice depended on that.
using ChosenMap = std::variant<FoundMap, JudgedMap>;

/// Number of leaves of the key by which a map is judged: 20,000, or the number of roots if that is larger.
Index judged_leaves(const SphereRoots& roots);

/// Samples, smooths and measures. If so many leaves of a matched map are turned over, or needles, that smoothing cannot
/// mend all of them, the key is neither smoothed nor measured: the distances of its quality stay 0.
/// \param least_angle  degrees; leaves with a smaller angle are needles, which the caller refuses. 0 for none
JudgedMap judge(std::shared_ptr<const AlignedMap> map, const SphereRoots& roots, const FitLimits& limits,
                double least_angle, Stopwatch& stopwatch, const Progress& progress);

/// Smooths and measures, unless the key is judged already.
/// \throw Cancelled
JudgedMap judge(ChosenMap chosen, const SphereRoots& roots, const FitLimits& limits, Stopwatch& stopwatch,
                const Progress& progress);

/// Maps, centers, checks and samples a clean mesh.
/// \throw InputError  if no map is one to one; a LandmarkError (pinned_map.h) at once
/// \throw Cancelled
ChosenMap choose_map(const SurfaceMesh& mesh, const MapChoiceOptions& options, Stopwatch& stopwatch,
                     const Progress& progress);

}  // namespace interleaf
