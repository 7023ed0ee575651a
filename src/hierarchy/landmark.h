// Landmarks: named points of a surface, such as the nose. Where two surfaces have landmarks of one name, these
// points correspond.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace interleaf {

struct Landmark {
    std::string name;        ///< unique in its set, not empty
    glm::dvec3 position{0};  ///< in space, on the surface or near it
    /// On the sphere to which all surfaces of a family are mapped: a unit vector. None if a map is still to
    /// choose it.
    std::optional<glm::dvec3> direction{};
};

struct LandmarkSet {
    std::vector<Landmark> landmarks;
    /// Names of landmarks that mirror each other, such as the left and the right ear.
    std::vector<std::array<std::string, 2>> symmetric{};
};

/// Where a landmark is on the sphere over which all keys of a family were sampled.
struct LandmarkDirection {
    std::string name;
    glm::dvec3 direction{0};  ///< a unit vector

    bool operator==(const LandmarkDirection&) const = default;
};

}  // namespace interleaf
