// Maps a surface to the sphere so that its landmarks lie at given directions, to the last bit, and the map is
// one to one.
//
// A progressive map (progressive_mapping.h) stops at a coarse mesh that has all landmarks. That mesh is turned
// so that the landmarks lie near their targets. A flow (sphere_flow.h) carries them there in short stages, a
// few landmarks first, those farthest apart; the map is relaxed after each stage. From then on, the landmarks
// stay where they are, and the other vertices return around them.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "fit/landmarks/landmark_agreement.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sphere_map/spherical_star.h"
#include "hierarchy/error.h"
#include "hierarchy/progress.h"

namespace interleaf {

struct PinnedMap {
    std::vector<glm::dvec3> points;  ///< unit vectors, one per vertex of the mesh
    LandmarkAgreement agreement;
};

struct PinnedMapOptions {
    Keeps keeps = Keeps::shapes;
    double crowded = 0;  ///< as for map_to_sphere() (spherical_map.h)
};

/// Landmarks that are probably wrong prevent the map. Other ways to map the mesh are not worth their time.
struct LandmarkError : InputError {
    using InputError::InputError;
};

/// The same input gives the same bits.
/// \param mesh  clean (clean_up.h), with the landmarks as vertices (landmark_insertion.h)
/// \throw InputError if there is no such map, naming the landmark that is farthest from its target; a
///                   LandmarkError if landmarks are probably wrong
/// \throw Cancelled  when \p progress says so
PinnedMap map_to_pins(const SurfaceMesh& mesh, const LandmarkPins& pins, const PinnedMapOptions& options,
                      const Progress& progress);

}  // namespace interleaf
