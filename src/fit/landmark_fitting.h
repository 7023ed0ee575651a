// The landmarks of a fit: pins of the mesh before the map, and the report after it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/aligned_map.h"
#include "fit/landmarks/landmark_agreement.h"
#include "fit/landmarks/landmark_report.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sphere_map/sphere_roots.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/landmark.h"

namespace interleaf {

/// \throw UsageError if only some of the landmarks have directions
void check_directions(std::span<const Landmark> landmarks);

/// A mesh with landmarks as vertices.
struct PinnedMesh {
    SurfaceMesh mesh;
    LandmarkPins pins;
};

/// None if the landmarks have no directions; they are checked nevertheless.
/// \param mesh       clean (clean_up.h)
/// \param symmetric  names of landmarks that mirror each other
/// \param counterparts  where the landmarks are on the first body; empty if that is not known
/// \throw InputError naming two landmarks that are at one point or have one direction
std::optional<PinnedMesh> pinned_mesh(const SurfaceMesh& mesh, std::span<const Landmark> landmarks,
                                      std::span<const std::array<std::string, 2>> symmetric = {},
                                      std::span<const glm::dvec3> counterparts = {});

/// A key with the roots over which it was sampled.
struct KeyOverRoots {
    const Hierarchy& hierarchy;
    const SphereRoots& roots;
};

/// \param map  of the surface with the landmarks
std::vector<FittedLandmark> fitted_landmarks(std::span<const Landmark> landmarks, const AlignedMap& map,
                                             const KeyOverRoots& key);

/// Sentences about landmarks that are far from the mesh.
std::vector<std::string> faults_of_places(std::span<const FittedLandmark> landmarks);

}  // namespace interleaf
