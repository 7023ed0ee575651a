// Keys within a second, for a person who sets landmarks: mapped and sampled coarsely, neither matched nor smoothed
// nor judged.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "fit/landmarks/landmark_agreement.h"
#include "fit/landmarks/landmark_targets.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sphere_map/sphere_roots.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/landmark.h"
#include "hierarchy/progress.h"

namespace interleaf {

/// The first body, to which others correspond.
struct PreviewReference {
    SurfaceMesh mesh;
    std::vector<glm::dvec3> points;  ///< the map of that mesh: of the unit sphere, one per vertex
    Hierarchy key;
};

struct PreviewOptions {
    SphereRoots roots;
    Index leaves = 6000;
    glm::dmat3 rotation{1};  ///< applied to a map without landmarks after the alignment
};

/// \param mesh  clean
/// \throw InputError if the mesh has no map to the sphere
/// \throw Cancelled
PreviewReference preview_reference(SurfaceMesh mesh, const PreviewOptions& options, const Progress& progress);

/// The same for a key that exists. Its surface is the mesh.
/// \param roots  over which \p key was sampled
PreviewReference preview_reference(Hierarchy key, const SphereRoots& roots);

/// Landmarks at given positions, moved to the nearest points of the reference, with their directions.
std::vector<Landmark> targets_on(const PreviewReference& reference, std::span<const Landmark> landmarks);

struct PreviewKey {
    Hierarchy key;
    LandmarkAgreement agreement;
    std::vector<std::string> faults;  ///< sentences about landmarks that are probably wrong
};

/// \param mesh       clean
/// \param aimed      landmarks with the targets on the reference; may be empty
/// \param symmetric  names of landmarks that mirror each other
/// \throw InputError if there is no map, naming a landmark
/// \throw Cancelled
PreviewKey preview_key(const SurfaceMesh& mesh, const AimedLandmarks& aimed,
                       std::span<const std::array<std::string, 2>> symmetric, const PreviewOptions& options,
                       const Progress& progress);

}  // namespace interleaf
