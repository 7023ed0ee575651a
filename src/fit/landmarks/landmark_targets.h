// Matches the landmarks of a mesh by name with those of the first mesh, and places the mesh in space by them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/landmarks/similarity.h"
#include "hierarchy/landmark.h"

namespace interleaf {

/// How landmarks place a mesh in space.
enum class LandmarkPlacing {
    keep,        ///< not at all
    rigid,       ///< turned and moved
    similarity,  ///< scaled, too
};

/// Landmarks with the targets of the same names.
struct AimedLandmarks {
    std::vector<Landmark> landmarks;    ///< in the order of the mesh, with the directions of the targets
    std::vector<glm::dvec3> positions;  ///< of the targets
    std::vector<std::string> remarks;   ///< sentences about landmarks that only one side has
};

/// \param targets  landmarks with directions
/// \throw InputError if no name is on both sides
AimedLandmarks aim(std::span<const Landmark> landmarks, std::span<const Landmark> targets);

/// The map of space that brings landmarks nearest to the positions of their targets.
/// \param placing  by default, a similarity for three landmarks or more
/// \return none to keep the mesh where it is
/// \throw InputError if the landmarks do not determine the map, saying what \a --place does about it
std::optional<Similarity> placement_of(const AimedLandmarks& aimed, std::optional<LandmarkPlacing> placing);

}  // namespace interleaf
