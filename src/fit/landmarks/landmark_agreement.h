// How well the landmarks of a mesh agree with their targets before the map is deformed, and what is probably
// wrong where they do not.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// Landmarks that are vertices of a mesh, with their targets. All vectors have one entry per landmark.
struct LandmarkPins {
    std::vector<std::string> names;
    std::vector<Index> vertices;         ///< all different
    std::vector<glm::dvec3> directions;  ///< unit vectors, all different
};

/// After the rotation of the map that turns the landmarks best toward their targets.
struct LandmarkAgreement {
    double mean_cosine = 1;      ///< between landmarks and targets
    double mirrored_cosine = 0;  ///< the same for the best reflection of the map
    std::size_t farthest = 0;    ///< the landmark farthest from its target

    /// Whether landmarks are probably wrong.
    bool is_doubtful() const;
};

/// Sentences about landmarks that probably are wrong: they lie very differently than their targets, or fit
/// better mirrored.
/// \param names  of the landmarks
std::vector<std::string> faults_of(const LandmarkAgreement& agreement, const std::vector<std::string>& names);

/// What to do where no key comes about: "; the landmark 'nose' is ...".
std::string advice_on(const LandmarkAgreement& agreement, const std::vector<std::string>& names);

}  // namespace interleaf
