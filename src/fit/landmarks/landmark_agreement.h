// How well the landmarks of a mesh agree with their targets before the map is deformed, and what is probably
// wrong where they do not.
#pragma once

#include <array>
#include <cstddef>
#include <span>
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

    /// Pairs of landmarks that mirror each other, such as the left and the right ear.
    std::vector<std::array<std::size_t, 2>> symmetric{};

    /// Where the landmarks are in space, and where their counterparts are on the first body; both empty if that is not
    /// known.
    std::vector<glm::dvec3> positions{};
    std::vector<glm::dvec3> counterparts{};
};

/// After the rotation of the map that turns the landmarks best toward their targets.
struct LandmarkAgreement {
    double mean_cosine = 1;      ///< between landmarks and targets
    double mirrored_cosine = 0;  ///< the same for the best reflection of the map
    std::size_t farthest = 0;    ///< the landmark farthest from its target
    std::vector<double>
        ways{};  ///< per landmark, its distance from its target, as a chord of the unit sphere

    /// The mean cosine if the two landmarks of each symmetric pair changed places; -1 without such pairs.
    double exchanged_cosine = -1;

    /// Neighboring landmarks that lie the other way round than their targets, and not clearly right in space.
    std::vector<std::array<std::size_t, 2>> reversed{};

    /// Whether landmarks are probably wrong.
    bool is_doubtful() const;
};

/// How well landmarks at \p points agree with their targets. Leaves out the ways.
/// \param points  of the unit sphere, one per landmark, in any position
LandmarkAgreement agreement_of(std::span<const glm::dvec3> points, const LandmarkPins& pins);

/// Sentences about landmarks that probably are wrong: they lie very differently than their targets, fit better
/// mirrored, or two of them are swapped.
std::vector<std::string> faults_of(const LandmarkAgreement& agreement, const LandmarkPins& pins);

/// What to do where no key comes about: "; the landmark 'nose' is ...".
std::string advice_on(const LandmarkAgreement& agreement, const LandmarkPins& pins);

}  // namespace interleaf
